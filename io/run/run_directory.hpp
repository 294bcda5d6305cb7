// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/run_lock.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace gyro {

/// What the command line says about the output.
struct RunDirectoryRequest {
  std::optional<std::filesystem::path> out = {};  ///< --out
  std::string case_name = {};                     ///< names runs/<case>-NNN when there is no --out
  bool resume = false, overwrite = false;
  std::shared_ptr<RunLock> lock = {};  ///< of `out`, when it is held already (lock_run_directory)
};

/// The directory a run writes to, which exists and can be written.
struct RunDirectory {
  enum class State {
    fresh,      ///< holds no run: start at the beginning
    half_done,  ///< holds a run that --resume continues
    finished    ///< holds a run with status `done`: leave it alone, or continue if --resume asks for a later end
  };
  std::filesystem::path path;
  State state = State::fresh;
  double simulated_seconds = 0;        ///< of the finished or half-done run, as far as its summary says
  std::shared_ptr<RunLock> lock = {};  ///< while it lives, no other run writes here; none for a finished run
};

/// Keeps other runs out of a directory that holds a run already, before that is looked at.
/// @returns nothing when there is no run at `out`, or when nobody may write there
/// @throws BadInput when another run writes there now
std::shared_ptr<RunLock> lock_run_directory(const std::optional<std::filesystem::path>& out);

/// What open_run_directory() would find, without writing anything. Without `out` it is a fresh run and the
/// path is empty. @throws BadInput as open_run_directory
RunDirectory find_run_directory(const RunDirectoryRequest& request);

/// Finds or makes the directory of a run. Without `out` it is runs/<case>-NNN below the working
/// directory, always a new one. `--overwrite` removes the files that a run writes and no others.
/// --resume of a directory without a run starts a fresh one, so that a scheduler may always pass it.
/// @throws BadInput for a half-done run without resume or overwrite, for both of them, for one of them
///         without `out`, if `out` is not a directory, or if another run writes there
/// @throws OutputError when it cannot be made or written
RunDirectory open_run_directory(const RunDirectoryRequest& request);

}  // namespace gyro
