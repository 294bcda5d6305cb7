// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/writer_thread.hpp"

#include <signal.h>

#include <utility>

namespace gyro {
namespace {

/// Blocks all signals for the threads that are started meanwhile: a signal belongs to the thread that runs the case.
class NoSignals {
 public:
  NoSignals() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_SETMASK, &all, &before_);
  }
  ~NoSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  NoSignals(const NoSignals&) = delete;
  NoSignals& operator=(const NoSignals&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

WriterThread::~WriterThread() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void WriterThread::add(std::function<void()> job) {
  if (!thread_.joinable()) start();
  {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return failure_ || jobs_.size() < max_jobs; });
    require_sound();
    jobs_.push_back(std::move(job));
  }
  changed_.notify_all();
}

void WriterThread::finish() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.empty(); });
  require_sound();
}

void WriterThread::check() {
  const std::lock_guard lock(mutex_);
  require_sound();
}

void WriterThread::drop() {
  const std::lock_guard lock(mutex_);
  jobs_.resize(busy_ ? 1 : 0);
}

void WriterThread::start() {
  const NoSignals meanwhile;
  thread_ = std::thread([this] { work(); });
}

void WriterThread::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return over_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    busy_ = true;
    const std::function<void()>& job = jobs_.front();  // stays in place while others are added behind it
    std::exception_ptr failure;
    lock.unlock();
    try {
      job();
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    busy_ = false;
    jobs_.pop_front();
    if (failure) {
      failure_ = failure;
      jobs_.clear();
    }
    changed_.notify_all();
  }
}

void WriterThread::require_sound() const {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace gyro
