// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/drivetrain.hpp"

#include <cmath>
#include <numbers>

// Drives that the groups drivetrain and coupling share.

namespace gyro::verify {

inline constexpr double rpm = std::numbers::pi / 30;  ///< [rad/s]

/// Kloss motor of the analytic run-up: breakdown torque 1000 N m at slip 0.1, synchronous at 100 rad/s.
inline InductionMotor textbook_kloss() {
  const double ratio = 2.5, breakdown_torque = 1000, breakdown_slip = 0.1, synchronous = 100;
  const double rated_slip = breakdown_slip / (ratio + std::sqrt(ratio * ratio - 1));
  return {.rated_power = breakdown_torque / ratio * synchronous * (1 - rated_slip),
          .synchronous_speed = synchronous,
          .rated_slip = rated_slip,
          .breakdown_ratio = ratio};
}

/// Motor of 450 kW, 600 rpm synchronous.
inline InductionMotor induction_450kw() {
  return {.rated_power = 450e3, .synchronous_speed = 600 * rpm, .rated_slip = 0.0167, .breakdown_ratio = 2.5};
}

/// Window number k of a run in windows of equal length.
inline Window window_number(std::int64_t k, double length, int steps = 1) {
  return {.first_step = k * steps, .steps = steps, .dt = length / steps};
}

/// One window against `torque(begin angle, end angle)`, the rock's mean torque along the wall's path.
template <class Torque>
void exchange(Drivetrain& drivetrain, const Window& window, const Torque& torque) {
  const MantlePath path = drivetrain.predict(window);
  const double turn = path.speed * window.length(), mean = torque(path.angle, path.angle + turn);
  drivetrain.advance(window, {.work = mean * turn, .resisting_torque = mean});
}

inline double no_rock(double, double) {
  return 0;
}

}  // namespace gyro::verify
