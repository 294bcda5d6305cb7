// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/library_wait.hpp"

#include "io/run/progress.hpp"

#include <iostream>
#include <mutex>
#include <utility>

namespace gyro {
namespace {

constexpr std::chrono::seconds first_line{2}, between_lines{10};

}  // namespace

struct LibraryWait::State {
  std::function<Clock::time_point()> clock;
  std::ostream& out;
  std::mutex mutex = {};
  Clock::time_point begin = clock(), next = begin + first_line;
  int most = 0;  ///< rocks made
};

LibraryWait::LibraryWait() : LibraryWait(Clock::now, std::cerr) {}

LibraryWait::LibraryWait(std::function<Clock::time_point()> now, std::ostream& out)
    : state_(new State{.clock = std::move(now), .out = out}) {}

void LibraryWait::operator()(int made, int of) const {
  const std::lock_guard lock(state_->mutex);
  const Clock::time_point now = state_->clock();
  if (made <= state_->most) return;  // another thread was faster
  state_->most = made;
  if (now < state_->next || made == of) return;
  state_->next = now + between_lines;
  // Large rocks come first, so that it is faster than this.
  const double seconds = std::chrono::duration<double>(now - state_->begin).count() / made * (of - made);
  state_->out << "library: " << made << " of " << of << " rocks made, less than " << format_duration(seconds)
              << " left\n";
}

}  // namespace gyro
