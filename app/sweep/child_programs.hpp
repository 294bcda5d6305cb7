// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <csignal>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace gyro {

/// A child program that has ended.
struct EndedChild {
  pid_t id = 0;
  int code = 0;    ///< exit code; 128 + signal if a signal ended it
  int signal = 0;  ///< that ended it; 0: none
};

/// Programs that run beside this one. While this object exists, SIGTERM, SIGINT, SIGHUP, SIGUSR1 and SIGXCPU do not end
/// the calling process, except those that its caller ignores; wait() returns them. The children are in process groups
/// of their own, so that Ctrl-C reaches only the caller, and get SIGTERM when the caller dies.
class ChildPrograms {
 public:
  ChildPrograms();
  /// The signals act as before; those that wait are dropped. Children that still run are left to themselves.
  ~ChildPrograms();
  ChildPrograms(const ChildPrograms&) = delete;
  ChildPrograms& operator=(const ChildPrograms&) = delete;

  /// Starts this program again with other arguments. Output and errors are added to a file.
  /// @throws OutputError if the file cannot be opened; NoDevice if the system starts no more processes
  pid_t start_self(const std::vector<std::string>& arguments, const std::filesystem::path& log);
  /// Waits until a child ends or a signal arrives. @returns the signal; 0 for none
  int wait(std::chrono::milliseconds longest);
  /// Children that have ended since the last call.
  std::vector<EndedChild> take_ended();
  /// Sends a signal to all children.
  void send(int signal) const;
  std::size_t running() const { return running_.size(); }

 private:
  sigset_t signals_{}, before_{};
  std::vector<pid_t> running_;
};

}  // namespace gyro
