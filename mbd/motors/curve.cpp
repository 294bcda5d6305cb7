// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/motors/curve.hpp"

#include "mbd/motors/check.hpp"

#include <algorithm>
#include <functional>

namespace gyro {

void CurveMotor::check() const {
  const auto not_finite = [](double value) { return !std::isfinite(value); };
  if (speeds.size() < 2 || speeds.size() != torques.size())
    throw BadInput("motor: the curve has " + std::to_string(speeds.size()) + " speeds and " +
                   std::to_string(torques.size()) + " torques; it must have the same number of both, at least two");
  if (std::ranges::any_of(speeds, not_finite) || std::ranges::any_of(torques, not_finite))
    throw BadInput("motor: a value of the curve is not finite; all must be numbers");
  if (std::ranges::adjacent_find(speeds, std::greater_equal{}) != speeds.end())
    throw BadInput("motor: the speeds of the curve do not increase; each must be above the one before");
  if (speeds.front() > 0) throw BadInput("motor: the curve begins above standstill; its first speed must be <= 0");
  if (torques.back() > 0)
    throw BadInput(
        "motor: the torque at the last speed of the curve is > 0; continue the curve to a speed at which the torque "
        "has fallen to 0 or below");
  if (std::ranges::none_of(torques, [](double torque) { return torque > 0; }))
    throw BadInput("motor: no torque of the curve is > 0; the motor must drive forward at some speed");
  require_positive(no_load_speed(), "speed of zero torque on the curve");
}

double CurveMotor::torque(double speed, double voltage) const {
  const double square = voltage * voltage;
  if (speed <= speeds.front()) return square * torques.front();
  const auto above = std::ranges::upper_bound(speeds, speed);
  const auto right = std::min<std::size_t>(above - speeds.begin(), speeds.size() - 1);
  const double slope = (torques[right] - torques[right - 1]) / (speeds[right] - speeds[right - 1]);
  return square * (torques[right - 1] + slope * (speed - speeds[right - 1]));
}

double CurveMotor::no_load_speed() const {
  std::size_t last_driving = torques.size() - 1;
  while (torques[last_driving] <= 0) --last_driving;
  const double share = torques[last_driving] / (torques[last_driving] - torques[last_driving + 1]);
  return speeds[last_driving] + share * (speeds[last_driving + 1] - speeds[last_driving]);
}

}  // namespace gyro
