// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/run_lock.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace gyro {

/// The options of the command line for the output.
struct RunDirectoryRequest {
  std::optional<std::filesystem::path> out = {};  ///< --out
  std::string case_name = {};                     ///< for the name runs/<case>-NNN if there is no --out
  bool resume = false, overwrite = false;
  std::shared_ptr<RunLock> lock = {};  ///< of `out`, if it is already held (lock_run_directory)
};

/// The directory of a run.
struct RunDirectory {
  enum class State {
    fresh,      ///< holds no run: the run starts at the beginning
    half_done,  ///< holds a run that --resume continues
    finished    ///< holds a run with status `done`: it is left unchanged, or continued if --resume asks for a later end
  };
  std::filesystem::path path;
  State state = State::fresh;
  double simulated_seconds = 0;        ///< of the finished or half-done run, from its summary
  std::shared_ptr<RunLock> lock = {};  ///< while it exists, no other run writes here; empty for a finished run
};

/// Locks a directory that already holds a run, before the run is examined.
/// @returns nothing if there is no run at `out`, or if the directory cannot be written
/// @throws BadInput if another run is writing there
std::shared_ptr<RunLock> lock_run_directory(const std::optional<std::filesystem::path>& out);

/// Finds what open_run_directory() would find, without writing anything. Without `out` the result is a fresh run with
/// an empty path. @throws BadInput for the reasons of open_run_directory
RunDirectory find_run_directory(const RunDirectoryRequest& request);

/// Finds or creates the directory of a run. Without `out` it is runs/<case>-NNN in the working directory, always a new
/// one. --overwrite removes only files that a run writes. --resume of a directory without a run starts a fresh run, so
/// that a job script can always use it.
/// @throws BadInput for a half-done run without resume or overwrite, if both are given, if one of them is given without
///         `out`, if `out` is not a directory, or if another run is writing there
/// @throws OutputError if the directory cannot be created or written
RunDirectory open_run_directory(const RunDirectoryRequest& request);

}  // namespace gyro
