// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/sweep_file.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// A point of a sweep: one combination of the axes, with one seed.
struct SweepPoint {
  std::vector<SweepSetting> varied;  ///< in the order of the axes
  std::optional<SweepSeed> seed;     ///< none: the seed of the case
};

/// Number of points of a sweep, at most `limit` + 1.
std::size_t count_points(const SweepFile& sweep, std::size_t limit);

/// All combinations of the axes and seeds; the seed changes fastest, then the last axis.
std::vector<SweepPoint> expand(const SweepFile& sweep);

/// All settings of a point in the order in which they are applied: those of all points, its own, its seed.
std::vector<SweepSetting> settings_of(const SweepFile& sweep, const SweepPoint& point);

/// The settings as `gyrosim run --set` takes them.
std::vector<std::string> overrides_of(const std::vector<SweepSetting>& settings);

/// The keys that vary, in the order of the axes.
std::vector<std::string> varied_keys(const SweepFile& sweep);

}  // namespace gyro
