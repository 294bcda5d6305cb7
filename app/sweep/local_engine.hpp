// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/point_state.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace gyro {

/// How points are run on this machine.
struct LocalOptions {
  int jobs = 1;        ///< runs side by side
  bool retry = false;  ///< also points that a guard has stopped or that have failed
  bool quiet = false;  ///< prints nothing
};

/// What has become of the points.
struct LocalOutcome {
  int done = 0, interrupted = 0, stopped = 0, failed = 0;
  int elsewhere = 0;       ///< being run by another process
  bool by_signal = false;  ///< a signal has ended the sweep before all points were tried
};

/// Whether a point is to be run in this state.
bool is_due(PointState state, bool retry);

/// The command line of `gyrosim` that runs or continues a point.
std::vector<std::string> run_arguments(const std::filesystem::path& directory, const CheckedSweep& sweep,
                                       const CheckedPoint& point);

/// Runs the points that are due as child processes of this program, and says on standard error when one starts or ends.
/// A signal is passed on to the runs, which write checkpoints. A second SIGINT ends runs and program at once.
LocalOutcome run_locally(const std::filesystem::path& directory, const CheckedSweep& sweep,
                         const LocalOptions& options);

/// Exit code of the program: 75 if points remain that a repeated call continues, else 1 if some failed, else 4 if a
/// guard stopped some, else 0.
int exit_code(const LocalOutcome& outcome);

}  // namespace gyro
