// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/motors/droop.hpp"

#include "mbd/motors/check.hpp"

#include <numbers>

namespace gyro {

void DroopMotor::check() const {
  require_positive(synchronous_speed, "synchronous_speed");
  require_positive(stall_torque, "stall_torque");
}

DroopMotor paper_droop() {
  const double rpm = std::numbers::pi / 30;
  const double gear_ratio = 3.75;
  const double stall_at_eccentric = 21e3 * 160 / (160 - 125);  // the line through the two points
  return {.synchronous_speed = 600 * rpm, .stall_torque = stall_at_eccentric / gear_ratio};
}

}  // namespace gyro
