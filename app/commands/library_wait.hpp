// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <iosfwd>
#include <memory>

namespace gyro {

/// Says on standard error how far the library of rocks is, where it takes more than two seconds. A LibraryProgress.
class LibraryWait {
 public:
  using Clock = std::chrono::steady_clock;

  LibraryWait();
  /// The same with another clock and stream.
  LibraryWait(std::function<Clock::time_point()> now, std::ostream& out);
  void operator()(int made, int of) const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

}  // namespace gyro
