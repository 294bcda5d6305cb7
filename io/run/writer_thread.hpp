// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace gyro {

/// Does jobs on a second thread, in the order in which they were added. The caller does not wait for them. A job must
/// own the data that it reads. The thread starts with the first job; where the system starts no more threads, the
/// caller does it.
///
/// The first job that fails is the last one that is done: those behind it are dropped, and each later call throws what
/// it has thrown.
class WriterThread {
 public:
  WriterThread() = default;
  /// Waits until all jobs are done, without reporting failures. Normally finish() was called before.
  ~WriterThread();
  WriterThread(const WriterThread&) = delete;
  WriterThread& operator=(const WriterThread&) = delete;

  static constexpr std::size_t max_jobs = 2;  ///< that are not done, the one that is being done included

  /// Waits while there are max_jobs. A caller whose jobs own much memory waits here before it makes the next one, so
  /// that at most max_jobs exist.
  void wait_for_room();
  /// Waits while there are max_jobs.
  void add(std::function<void()> job);
  /// Waits until all jobs are done.
  void finish();
  /// Throws if a job has failed; does not wait.
  void check();

 private:
  using Lock = std::unique_lock<std::mutex>;
  bool start();
  void work();
  void wait_for_room(Lock& lock);
  void note(const std::exception_ptr& failure);
  void require_sound() const;

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;  ///< not done; the first is empty while it is being done
  bool over_ = false;
  std::exception_ptr failure_;
  std::thread thread_;
};

}  // namespace gyro
