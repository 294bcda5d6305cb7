// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/checked_points.hpp"

#include <cstdint>
#include <filesystem>
#include <string>

namespace gyro {

/// The last line that is not empty of what a file holds after `begin` [bytes].
std::string last_line(const std::filesystem::path& file, std::uintmax_t begin);

/// Why a run has ended, from its summary; otherwise `line`.
std::string reason_of(const std::filesystem::path& run, const std::string& line);

/// A message about an override, "--set:K:COLUMN: problem", with the place of its value in the sweep file; other
/// messages unchanged.
std::string placed_in_sweep(const std::string& line, const CheckedSweep& sweep, const CheckedPoint& point);

}  // namespace gyro
