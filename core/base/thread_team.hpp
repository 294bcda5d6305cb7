// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>
#include <vector>

namespace gyro {

/// Threads that wait for short jobs: they compute all steps of a run. A step of a small scene is three jobs of some 50
/// us, so that the wait between them decides: a thread looks for the next job for about 150 us, longer than a job that
/// is too small to share, then sleeps. OpenMP's barriers either always sleep (waking up costs more than the job) or
/// look for milliseconds, which made a run on a busy machine six times slower with two threads than with one.
class ThreadTeam {
 public:
  /// @param threads  at least 1, the caller's among them
  /// @throws std::system_error when the system starts no more threads
  explicit ThreadTeam(int threads) : threads_(threads) {
    GYRO_EXPECT(threads >= 1);
    try {
      for (int t = 1; t < threads_; ++t) workers_.emplace_back([this, t] { serve(t); });
    } catch (...) {
      dismiss();
      throw;
    }
  }
  ~ThreadTeam() { dismiss(); }
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const { return threads_; }

  /// Calls work(t) once for each t in [0, size), on as many threads, and returns when all are done.
  template <class Work>
  void run(const Work& work) {
    if (threads_ == 1) return work(0);
    call_ = [](const void* w, int t) { (*static_cast<const Work*>(w))(t); };
    work_ = &work;
    pending_.store(threads_ - 1, std::memory_order_relaxed);
    issue();
    work(0);
    for (int looks = 0; pending_.load(std::memory_order_acquire) > 0; ++looks)
      looks < patience ? pause() : std::this_thread::yield();
  }

 private:
  static constexpr int patience = 3000;  // looks of about 50 ns: 150 us

  static void pause() {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }

  void dismiss() {
    stop_ = true;
    issue();
    for (std::thread& w : workers_) w.join();
  }

  void issue() {
    ticket_.fetch_add(1, std::memory_order_release);
    ticket_.notify_all();
  }

  void serve(int thread) {
    for (int done = 0;;) {
      for (int looks = 0; ticket_.load(std::memory_order_acquire) == done; ++looks) {
        if (looks < patience)
          pause();
        else
          ticket_.wait(done, std::memory_order_acquire);
      }
      ++done;
      if (stop_) return;
      call_(work_, thread);
      pending_.fetch_sub(1, std::memory_order_acq_rel);
    }
  }

  int threads_;
  std::vector<std::thread> workers_;
  std::atomic<int> ticket_{0}, pending_{0};
  std::atomic<bool> stop_{false};
  void (*call_)(const void*, int) = nullptr;
  const void* work_ = nullptr;
};

/// Threads that this machine runs at the same time, at least 1.
inline int all_cores() {
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// Calls work(k) once for each k in [0, count): a thread takes the next k when it is free, for long jobs of different
/// lengths. After all are done, the failure of the lowest k is thrown, if there is any.
template <class Work>
void for_each_job(ThreadTeam& team, int count, const Work& work) {
  std::atomic<int> next{0};
  std::mutex mutex;
  int failed = std::numeric_limits<int>::max();
  std::exception_ptr failure;
  team.run([&](int) {
    for (int k; (k = next.fetch_add(1, std::memory_order_relaxed)) < count;) {
      try {
        work(k);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (k < failed) failed = k, failure = std::current_exception();
      }
    }
  });
  if (failure) std::rethrow_exception(failure);
}

}  // namespace gyro
