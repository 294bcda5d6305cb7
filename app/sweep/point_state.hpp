// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/checked_points.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace gyro {

/// How far a point has come.
enum class PointState {
  waiting,    ///< has not begun
  half_done,  ///< can be continued
  done,
  stopped,  ///< by a guard
  failed,   ///< with another error
  running   ///< now, in another process
};

/// The word for tables: waiting, interrupted, done, stopped, failed, running.
const char* to_string(PointState state);

/// Reads how far a point has come from its directory. A run that ended before its end is half done when the sweep asks
/// for a later one now.
PointState state_of(const std::filesystem::path& directory, const CheckedSweep& sweep, const CheckedPoint& point);

/// The files of a sweep.
std::filesystem::path points_file(const std::filesystem::path& directory);
std::filesystem::path log_file(const std::filesystem::path& directory, const std::string& point);

/// What points.csv of an earlier call says.
struct EarlierPoint {
  std::string name;
  std::string inputs;  ///< see CheckedPoint
};
std::vector<EarlierPoint> read_points(const std::filesystem::path& directory);

/// points.csv: name, the values that vary, seed, and the digest of the files that the case names.
std::string points_table(const CheckedSweep& sweep);

/// Compares the points with what their directories hold.
/// @returns a problem for each point whose run has other settings or input files than the sweep gives it now
std::vector<CaseProblem> changed_points(const std::filesystem::path& directory, const CheckedSweep& sweep);

/// Names of the points of an earlier call that the sweep does not have any more.
std::vector<std::string> former_points(const std::filesystem::path& directory, const CheckedSweep& sweep);

/// One line of a CSV file.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace gyro
