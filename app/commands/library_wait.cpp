// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/library_wait.hpp"

#include "io/run/progress.hpp"

#include <chrono>
#include <iostream>
#include <mutex>

namespace gyro {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::seconds first_line{2}, between_lines{10};

}  // namespace

struct LibraryWait::State {
  std::mutex mutex;
  Clock::time_point begin = Clock::now(), next = begin + first_line;
  int most = 0;  ///< rocks made
};

LibraryWait::LibraryWait() : state_(std::make_shared<State>()) {}

void LibraryWait::operator()(int made, int of) const {
  const std::lock_guard lock(state_->mutex);
  const Clock::time_point now = Clock::now();
  if (made <= state_->most) return;  // another thread was faster
  state_->most = made;
  if (now < state_->next || made == of) return;
  state_->next = now + between_lines;
  // Large rocks come first, so that it is faster than this.
  const double seconds = std::chrono::duration<double>(now - state_->begin).count() / made * (of - made);
  std::cerr << "library: " << made << " of " << of << " rocks made, less than " << format_duration(seconds)
            << " left\n";
}

}  // namespace gyro
