// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/point_state.hpp"
#include "io/run/summary.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gyro {

/// A number of summary.json, or one made of them.
struct SweepFigure {
  std::string name;  ///< as in summary.json, with the name of its parent: "steady.p80"
  std::string units;
  std::string description;
};

/// A key of the case that varies from point to point.
struct SweepKey {
  std::string key;          ///< "crusher.closed_side_setting"
  std::string short_name;   ///< as in the names of points, "css"
  std::string units;        ///< SI unit, "1" for a pure number; "-" for text
  std::string description;  ///< of the key
};

/// What a point has come to.
struct PointResult {
  std::string name;                 ///< its directory, relative to that of the sweep
  std::string setting;              ///< its name without the seed
  std::vector<std::string> values;  ///< of the keys, as the sweep file gives them
  std::vector<std::string> si;      ///< the same in SI units, of the resolved case
  std::uint64_t seed = 0;
  PointState state = PointState::waiting;
  std::vector<double> figures;  ///< in the order of SweepResults::figures; NaN: none
};

/// All results of a sweep.
struct SweepResults {
  std::vector<SweepKey> keys;
  std::vector<SweepFigure> figures;  ///< those that at least one point has
  std::vector<PointResult> points;   ///< in the order of the sweep
};

/// Reads what the points have come to so far. Points that have no summary yet have no figures.
SweepResults collect(const std::filesystem::path& directory, const CheckedSweep& sweep);

/// The figures of a setting: means over its points that are done, which differ in the seed only.
struct SettingResult {
  std::string setting;
  std::vector<std::string> values, si;
  std::vector<std::uint64_t> seeds;  ///< of the points that are done
  int points = 0;                    ///< all points of the setting
  /// Mean and standard error of the mean, in the order of SweepResults::figures. The value is NaN if a point that is
  /// done lacks the figure, and the error if fewer than two points are done.
  std::vector<Estimate> figures;
};

/// The settings in the order of their first points.
std::vector<SettingResult> by_setting(const SweepResults& results);

/// Mean and standard error of the mean of independent values: s / sqrt(n), s^2 = sum (x - mean)^2 / (n - 1).
Estimate mean_of(const std::vector<double>& values);

/// Position of a figure; -1 if no point has it.
int find_figure(const SweepResults& results, const std::string& name);

}  // namespace gyro
