// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/writer_thread.hpp"

#include <system_error>
#include <utility>

namespace gyro {
namespace {

/// Does a job and frees what it owns. @returns what it has thrown
std::exception_ptr failure_of(std::function<void()> job) {
  try {
    job();
    return {};
  } catch (...) {
    return std::current_exception();
  }
}

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

void WriterThread::wait_for_room() {
  Lock lock(mutex_);
  wait_for_room(lock);
}

void WriterThread::add(std::function<void()> job) {
  const bool alone = !thread_.joinable() && !start();
  {
    Lock lock(mutex_);
    wait_for_room(lock);
    if (!alone) jobs_.push_back(std::move(job));
  }
  if (alone)
    note(failure_of(std::move(job)));
  else
    changed_.notify_all();
}

void WriterThread::finish() {
  Lock lock(mutex_);
  changed_.wait(lock, [this] { return jobs_.empty(); });
  require_sound();
}

void WriterThread::check() {
  const Lock lock(mutex_);
  require_sound();
}

/// @returns false if the system starts no more threads
bool WriterThread::start() {
  try {
    thread_ = std::thread([this] { work(); });
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

void WriterThread::work() {
  Lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return over_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    std::function<void()> job = std::move(jobs_.front());
    lock.unlock();
    const std::exception_ptr failure = failure_of(std::move(job));
    lock.lock();
    jobs_.pop_front();
    note(failure);
    changed_.notify_all();
  }
}

void WriterThread::wait_for_room(Lock& lock) {
  changed_.wait(lock, [this] { return failure_ || jobs_.size() < max_jobs; });
  require_sound();
}

void WriterThread::note(const std::exception_ptr& failure) {
  if (!failure) return;
  failure_ = failure;
  jobs_.clear();
}

void WriterThread::require_sound() const {
  if (failure_) std::rethrow_exception(failure_);
}

}  // namespace gyro
