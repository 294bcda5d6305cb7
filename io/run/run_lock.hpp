// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>

namespace gyro {

/// Times of a lock on a file system whose locks do not reach other machines.
struct LockTimes {
  std::chrono::milliseconds beat{10'000};  ///< between two signs of life
  std::chrono::milliseconds patience{
      45'000};  ///< a holder on another machine without a sign of life for so long is dead
};

/// The right to write into a run's directory, held by DIRECTORY/run.lock while this object lives.
///
/// The file is locked (fcntl), so the lock ends with its process, however that ends. It also names host, process and
/// time of its holder and gets a sign of life every few seconds. Where a file of another machine is found unlocked,
/// that machine may have died, or its locks may not be seen from here: then its signs of life are watched for a while.
class RunLock {
 public:
  /// @throws BadInput, with the holder, when another process writes into the directory
  /// @throws OutputError when the file cannot be made
  explicit RunLock(const std::filesystem::path& directory, LockTimes times = {});
  ~RunLock();
  /// Whether another run has taken the directory: this process was suspended, and its locks are not seen from the other
  /// machine.
  bool lost() const;
  RunLock(RunLock&&) noexcept;
  RunLock& operator=(RunLock&&) noexcept;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace gyro
