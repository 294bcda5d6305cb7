// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/motors/induction.hpp"

#include "mbd/motors/check.hpp"

#include <cmath>

namespace gyro {

void InductionMotor::check() const {
  require_positive(rated_power, "rated_power");
  require_positive(synchronous_speed, "synchronous_speed");
  require_positive(rated_slip, "rated_slip");
  if (rated_slip >= 1) throw BadInput("motor: rated_slip is 1 or more; it must be between 0 and 1");
  if (!(breakdown_ratio > 1) || !std::isfinite(breakdown_ratio))
    throw BadInput("motor: breakdown_ratio is not above 1; it must be > 1, usually 1.75 to 3");
}

double InductionMotor::rated_torque() const {
  return rated_power / rated_speed();
}

double InductionMotor::breakdown_torque() const {
  return breakdown_ratio * rated_torque();
}

double InductionMotor::breakdown_slip() const {
  return rated_slip * (breakdown_ratio + std::sqrt(breakdown_ratio * breakdown_ratio - 1));
}

double InductionMotor::torque(double speed, double voltage) const {
  const Cage cage{breakdown_torque(), breakdown_slip()};
  return voltage * voltage * cage.torque(slip_at(speed, synchronous_speed));
}

double InductionMotor::current(double speed) const {
  const Cage cage{1, breakdown_slip()};
  return std::abs(cage.current(slip_at(speed, synchronous_speed))) / std::abs(cage.current(rated_slip));
}

}  // namespace gyro
