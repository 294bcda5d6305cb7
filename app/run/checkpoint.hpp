// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/run_output.hpp"
#include "app/simulation/simulation.hpp"

#include <chrono>
#include <filesystem>
#include <string>

namespace gyro {

/// The state in a run's checkpoint.h5. @throws BadKey if it belongs to a different case, with the key that differs;
/// BadInput if the file cannot be used
SavedState read_checkpoint(const std::filesystem::path& directory, const Case& input);

std::filesystem::path checkpoint_file(const std::filesystem::path& directory);

/// @throws BadKey if the case.yaml of a run contains a different case
void require_same_case(const std::filesystem::path& directory, const Case& input);

/// Version and git hash of the program that wrote a checkpoint, and of this one.
std::string writer_of(const SavedState& checkpoint);
std::string this_program();

/// Keeps the last good state of a run: on disk every `output.checkpoints`, and in memory between these times, as long
/// as that takes less than a hundredth of the time. When a guard stops a run, the state in memory is written.
class CheckpointKeeper {
 public:
  CheckpointKeeper(const std::filesystem::path& directory, const Case& input);

  /// Keeps the state if it is due. Call it before the first window and after every window without a verdict.
  void keep_if_due(const Simulation& simulation, RunOutput& output);
  /// Writes the present state, between two windows.
  void write(const Simulation& simulation, RunOutput& output);
  /// Writes the last state that was kept.
  void write_last_good(RunOutput& output);

 private:
  using Clock = std::chrono::steady_clock;
  void keep(const Simulation& simulation, const RunOutput& output);

  std::filesystem::path file_;
  const Case& input_;
  SavedState good_;
  Clock::time_point kept_{}, written_ = Clock::now();
  Clock::duration cost_{};  ///< of keeping a state
};

}  // namespace gyro
