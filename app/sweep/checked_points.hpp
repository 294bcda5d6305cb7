// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/run/run_end.hpp"
#include "app/sweep/points.hpp"

#include <string>
#include <vector>

namespace gyro {

/// A point whose case has been loaded and found good.
struct CheckedPoint {
  SweepPoint point;
  std::string name;     ///< of the point and its directory
  std::string setting;  ///< name without the seed
  std::uint64_t seed = 0;
  std::vector<std::string> overrides;  ///< as --set takes them
  std::string resolved;                ///< the case with all defaults, see resolved_yaml()
  std::string inputs;                  ///< digest of the files that the case names; empty if it names none
  double end = 0;                      ///< simulated time at which the run ends at the latest [s]
};

/// A sweep that can be run, or all problems of its points.
struct CheckedSweep {
  SweepFile file;
  RunEnd until = {};
  std::vector<std::string> names = {};  ///< short names of the keys that vary
  std::vector<CheckedPoint> points = {};
  std::vector<CaseProblem> problems = {};
};

/// Loads the case of every point. A problem of a value is reported at its place in the sweep file, and one that many
/// points share is reported once. Two points with the same case are a problem too.
CheckedSweep check_points(const SweepFile& sweep);

/// The value of a key in a resolved case, in SI units; empty if the case leaves it out or it is a section.
std::string resolved_value(const std::string& resolved, const std::string& key);

}  // namespace gyro
