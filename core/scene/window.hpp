// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

namespace gyro {

/// One coupling interval: a whole number of steps. Time is always step count x dt, never a
/// sum of steps, so that long runs do not drift.
struct Window {
  std::int64_t first_step = 0;
  int steps = 0;
  double dt = 0;  ///< [s]

  double begin() const { return static_cast<double>(first_step) * dt; }
  double end() const { return static_cast<double>(first_step + steps) * dt; }
  double length() const { return steps * dt; }
};

/// Asked before each step of a window, on a device before each batch of them, with the share of its steps that are
/// done; whether the window is given up.
using GiveUp = std::function<bool(double share_done)>;

/// The eccentric over a window, as the drivetrain predicts it: constant speed, continuous angle.
struct MantlePath {
  double angle = 0;       ///< eccentric angle at the window's begin [rad]
  double speed = 0;       ///< eccentric speed [rad/s]
  double spin_angle = 0;  ///< of the mantle about its own axis, at the window's begin [rad]
  double spin = 0;        ///< of the mantle about its own axis [rad/s]
};

}  // namespace gyro
