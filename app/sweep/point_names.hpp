// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/points.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gyro {

/// A short name for each key: the one that the sweep file gives; otherwise the last part of the key, with as many parts
/// before it as make it differ from those of the other keys ("relative", "radius.relative").
std::vector<std::string> short_names(const std::vector<std::string>& keys,
                                     const std::map<std::string, std::string>& given);

/// A value with letters, digits, points, plus and minus only: "90 mm" becomes "90mm", [0, 1] 0+1. A value that loses
/// other characters or is long ends with a digest, so that different values stay different.
std::string value_in_name(const std::string& value);

/// Name of the settings of a point: "css-90mm_relative-0.5"; empty if nothing varies. Only the point's own values
/// decide it, so that names stay when points are added to a sweep.
/// @param names  of the keys of the point
std::string setting_name(const std::vector<std::string>& names, const SweepPoint& point);

/// Name of a point, which is its directory: "css-90mm_seed-3". At most 120 characters.
std::string point_name(const std::string& setting, std::uint64_t seed);

}  // namespace gyro
