// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/assembly.hpp"
#include "app/simulation/device.hpp"
#include "io/run/log.hpp"
#include "io/run/summary.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gyro {

/// The lines of a run's log.txt.
class RunLog {
 public:
  /// @param quiet  the first line is not shown on standard error as well
  RunLog(std::filesystem::path directory, bool quiet);

  void notes(const std::vector<std::string>& notes);
  /// That the run continues from a checkpoint. @param writer  the program that wrote it
  void resumed(const Simulation& simulation, const std::string& writer);
  /// Program, device, step and size of the run.
  void started(const Device& device, const StepChoice& step, const Simulation& simulation);
  /// That the drivetrain is native code, and what that means.
  void drive_fmu(const DriveFmu& fmu, const std::string& unsaveable);
  /// Messages and events of the drive since the last call.
  void drive_events(Simulation& simulation);
  void stopped(const std::string& reason);
  /// The summary as it is printed.
  void summary(const std::string& text);
  /// Time by phase, status, and warnings: of overlaps beyond Hertz's law, of rock that left over the rim.
  void ended(const Simulation& simulation, RunStatus status);

 private:
  std::filesystem::path directory_;
  bool quiet_;
  Log log_;
  std::int64_t drive_events_ = 0;  ///< logged so far
};

}  // namespace gyro
