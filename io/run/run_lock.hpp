// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>

namespace gyro {

/// Times of a lock on a file system whose locks are not visible on other machines.
struct LockTimes {
  std::chrono::milliseconds beat{10'000};  ///< time between two signs of life
  std::chrono::milliseconds patience{
      45'000};  ///< a holder on another machine that gives no sign of life in this time is taken to have ended
};

/// Part of the message of a lock that another process holds; a program that called the run can tell it from bad input.
constexpr const char* lock_is_held = "a run is still writing here";

/// The right to write into the directory of a run. DIRECTORY/run.lock holds it while this object exists.
///
/// The file is locked (fcntl), so that the lock ends with its process in any case. The file also contains host, process
/// and start time of its holder, and the holder writes a sign of life into it every few seconds. If a file of another
/// machine is not locked, that machine may have crashed, or its locks may not be visible here. The file is then watched
/// for signs of life for a while.
class RunLock {
 public:
  /// @throws BadInput, with the holder, if another process is writing into the directory
  /// @throws OutputError if the file cannot be created
  explicit RunLock(const std::filesystem::path& directory, LockTimes times = {});
  ~RunLock();
  /// Whether another run has taken over the directory. This can happen if this process was suspended and its locks are
  /// not visible on the other machine.
  bool lost() const;
  RunLock(RunLock&&) noexcept;
  RunLock& operator=(RunLock&&) noexcept;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

/// Whether a run is writing into a directory, as far as the locks of its file system show; nothing is written and
/// nobody is waited for. A run on a machine whose locks are not visible here counts as ended; RunLock finds it.
bool is_locked(const std::filesystem::path& directory);

}  // namespace gyro
