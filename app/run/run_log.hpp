// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/output/steady_goal.hpp"
#include "app/simulation/device.hpp"
#include "io/run/log.hpp"
#include "io/run/summary.hpp"

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace gyro {

/// The lines of a run's log.txt.
class RunLog {
 public:
  /// @param quiet  the first line is not printed on standard error
  RunLog(std::filesystem::path directory, bool quiet);

  void notes(const std::vector<std::string>& notes);
  /// Logs that the run continues from a checkpoint. @param writer  the program that wrote it
  void resumed(const Simulation& simulation, const std::string& writer);
  /// Logs program, device, step and size of the run.
  void started(const Device& device, const StepChoice& step, const Simulation& simulation);
  /// Logs what filled the chamber, and warns of rock that found no room.
  void filled(const Filled& filled);
  /// Warns that the drivetrain is native code, and that the run has no checkpoints if its state cannot be saved.
  void drive_fmu(const DriveFmu& fmu, const std::string& unsaveable);
  /// Logs messages and events of the drive since the last call.
  void drive_events(Simulation& simulation);
  void stopped(const std::string& reason);
  /// Logs the standard errors of a run until steady: when it becomes steady, and each time that the largest of them has
  /// fallen by a fifth. @param asked  relative standard error at which the run ends [-]
  void steady(const SteadyProgress& progress, double asked);
  /// Warns that the run has ended before its figures were known.
  void not_known(const std::string& reason);
  /// Warns that rows are left out.
  void lost_rows();
  /// Logs the summary as it is printed.
  void summary(const std::string& text);
  /// Logs time by phase, status, and warnings about overlaps beyond Hertz's law and rock that left over the rim.
  void ended(const Simulation& simulation, RunStatus status);

 private:
  std::filesystem::path directory_;
  bool quiet_;
  Log log_;
  std::int64_t drive_events_ = 0;  ///< logged so far
  /// Largest error when errors were last logged [-].
  double logged_error_ = std::numeric_limits<double>::max();
};

}  // namespace gyro
