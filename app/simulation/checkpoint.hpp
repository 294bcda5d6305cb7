// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/run_output.hpp"
#include "app/simulation/simulation.hpp"

#include <chrono>
#include <filesystem>

namespace gyro {

/// The state in a run's checkpoint.h5. @throws BadKey for a case that it does not belong to, naming the key that
/// differs; BadInput for a file that cannot be used
SavedState read_checkpoint(const std::filesystem::path& directory, const Case& input);

std::filesystem::path checkpoint_file(const std::filesystem::path& directory);

/// @throws BadKey when a run's case.yaml says another case than this
void require_same_case(const std::filesystem::path& directory, const Case& input);

/// Version and git hash of the program that wrote a checkpoint, and of this one.
std::string writer_of(const SavedState& checkpoint);
std::string this_program();

/// Keeps the last good state of a run: on disk every `output.checkpoints`, in memory in between, as often as
/// it costs less than a hundredth of the time. A run that a guard stops leaves the one in memory.
class CheckpointKeeper {
 public:
  CheckpointKeeper(const std::filesystem::path& directory, const Case& input);

  /// Takes up the state between two windows, before the first and after every sound one.
  void look_at(const Simulation& simulation, RunOutput& output);
  /// Writes the state between two windows.
  void write(const Simulation& simulation, RunOutput& output);
  /// Writes the last state that was taken up.
  void write_last_good(RunOutput& output);

 private:
  using Clock = std::chrono::steady_clock;
  void take(const Simulation& simulation, const RunOutput& output);

  std::filesystem::path file_;
  const Case& input_;
  SavedState good_;
  Clock::time_point taken_{}, written_ = Clock::now();
  Clock::duration cost_{};  ///< of taking a state
};

}  // namespace gyro
