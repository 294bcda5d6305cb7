// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"
#include "core/state/step_flags.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gyro {

/// How many steps a device is given before the host waits for them.
///
/// A wait costs as much as w steps that do nothing; a device that halts, on average, leaves half of the steps undone
/// that it was given. With L steps from one halt to the next and B steps at a time that is w L/B + B/2 steps a halt,
/// least for B = sqrt(2 w L). L is taken to be what it was last time, or what has passed since if that is more.
class BatchSize {
 public:
  /// @param max  steps at a time, at least 1
  explicit BatchSize(int max) : max_(std::max(1, max)) {}

  int steps() const {
    const double halts_apart = std::max({1.0, static_cast<double>(last_), static_cast<double>(since_)});
    return std::min(max_, static_cast<int>(std::sqrt(2 * wait_in_steps * halts_apart)));
  }
  void passed(int steps) { since_ += steps; }
  /// @param steps  since the last call of either function
  void halted(int steps) {
    last_ = since_ + steps;
    since_ = 0;
  }

 private:
  static constexpr double wait_in_steps =
      2;  // estimated: a copy of 8 bytes and a start, 15 us, against 6 empty kernels
  int max_;
  std::int64_t last_ = 0, since_ = 0;
};

/// Owns what is known of the steps that a device takes while the host does not look. Without such a device: nothing.
template <class Exec>
class StepsAhead {
 public:
  explicit StepsAhead(const Exec& exec) : size_(exec.max_steps_ahead()) {}

  BatchSize& size() { return size_; }
  void begin_window() { go_on_from(0); }

  /// For kernels; null without such a device.
  StepProgress* progress() { return progress_.data(); }
  const std::int32_t* step() { return Exec::runs_ahead ? &progress_.data()->step : nullptr; }
  const std::int32_t* halted() { return Exec::runs_ahead ? &progress_.data()->halted : nullptr; }

  /// Waits for the device.
  StepProgress reached() const { return Exec::host(progress_)[0]; }
  /// The host has done what step `step` of the window halted for.
  void go_on_from(int step) {
    if constexpr (Exec::runs_ahead) Exec::upload(progress_, std::vector<StepProgress>{{step, 0}});
  }

 private:
  typename Exec::template Buffer<StepProgress> progress_;  ///< one
  BatchSize size_;
};

}  // namespace gyro
