// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/motor.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

namespace gyro {

DroopMotor paper_droop() {
  const double rpm = std::numbers::pi / 30;
  const double gear_ratio = 3.75;
  const double stall_at_eccentric = 21e3 * 160 / (160 - 125);  // the line through the two points
  return {.synchronous_speed = 600 * rpm, .stall_torque = stall_at_eccentric / gear_ratio};
}

double CurveMotor::torque(double speed) const {
  if (speed <= speeds.front()) return torques.front();
  const auto above = std::ranges::upper_bound(speeds, speed);
  const auto right = std::min<std::size_t>(above - speeds.begin(), speeds.size() - 1);
  const double slope = (torques[right] - torques[right - 1]) / (speeds[right] - speeds[right - 1]);
  return torques[right - 1] + slope * (speed - speeds[right - 1]);
}

double CurveMotor::no_load_speed() const {
  std::size_t last_driving = torques.size() - 1;
  while (torques[last_driving] <= 0) --last_driving;
  const double share = torques[last_driving] / (torques[last_driving] - torques[last_driving + 1]);
  return speeds[last_driving] + share * (speeds[last_driving + 1] - speeds[last_driving]);
}

namespace {

void require_positive(double value, const char* name) {
  if (std::isfinite(value) && value > 0) return;
  throw BadInput(std::string("motor: ") + name + " is " + std::to_string(value) + "; accepted is a number > 0");
}

void check(const InductionMotor& motor) {
  require_positive(motor.rated_power, "rated_power");
  require_positive(motor.synchronous_speed, "synchronous_speed");
  require_positive(motor.rated_slip, "rated_slip");
  if (motor.rated_slip >= 1) throw BadInput("motor: rated_slip is 1 or more; accepted is 0 < rated_slip < 1");
  if (!(motor.breakdown_ratio > 1) || !std::isfinite(motor.breakdown_ratio))
    throw BadInput("motor: breakdown_ratio is not above 1; accepted is a number > 1, usually 1.75 to 3");
}

void check(const DoubleCageMotor& motor) {
  check(InductionMotor{motor.rated_power, motor.synchronous_speed, motor.rated_slip, motor.breakdown_ratio});
  require_positive(motor.starting_ratio, "starting_ratio");
  require_positive(motor.inner.breakdown_torque, "torque of the inner cage");
}

void check(const DroopMotor& motor) {
  require_positive(motor.synchronous_speed, "synchronous_speed");
  require_positive(motor.stall_torque, "stall_torque");
}

void check(const CurveMotor& motor) {
  const auto not_finite = [](double value) { return !std::isfinite(value); };
  if (motor.speeds.size() < 2 || motor.speeds.size() != motor.torques.size())
    throw BadInput("motor: the curve has " + std::to_string(motor.speeds.size()) + " speeds and " +
                   std::to_string(motor.torques.size()) + " torques; accepted are two or more pairs");
  if (std::ranges::any_of(motor.speeds, not_finite) || std::ranges::any_of(motor.torques, not_finite))
    throw BadInput("motor: the curve has a value that is not finite; accepted are numbers");
  if (std::ranges::adjacent_find(motor.speeds, std::greater_equal{}) != motor.speeds.end())
    throw BadInput("motor: the speeds of the curve do not increase; accepted is each speed above the one before");
  if (motor.speeds.front() > 0)
    throw BadInput("motor: the curve begins above standstill; accepted is a first speed <= 0");
  if (motor.torques.back() > 0)
    throw BadInput(
        "motor: the torque at the last speed of the curve is > 0; accepted is a curve up to the speed "
        "where the torque has fallen to 0 or below");
  if (std::ranges::none_of(motor.torques, [](double torque) { return torque > 0; }))
    throw BadInput("motor: no torque of the curve is > 0; accepted is a motor that drives forward");
  require_positive(motor.no_load_speed(), "speed of zero torque on the curve");
}

void check(const ConstantSpeedMotor& motor) {
  require_positive(motor.speed, "speed");
}

/// Torque of a law at a voltage: squared for all but the droop, whose speed of zero torque moves instead.
template <class Law>
double torque_of(const Law& law, double speed, double voltage) {
  return voltage * voltage * law.torque(speed);
}
double torque_of(const DroopMotor& law, double speed, double voltage) {
  return law.stall_torque * (voltage - speed / law.synchronous_speed);
}
double torque_of(const ConstantSpeedMotor&, double, double) {
  return 0;
}

}  // namespace

double motor_torque(const Motor& motor, double speed, double voltage) {
  return std::visit([&](const auto& law) { return torque_of(law, speed, voltage); }, motor);
}

double motor_current(const Motor& motor, double speed, double voltage, double rated_torque) {
  return std::visit(
      [&](const auto& law) {
        if constexpr (requires { law.current(speed); })
          return voltage * law.current(speed);
        else
          return std::abs(torque_of(law, speed, voltage)) / rated_torque;
      },
      motor);
}

double rated_torque_of(const Motor& motor) {
  return std::visit(
      [](const auto& law) -> double {
        if constexpr (requires { law.rated_torque(); })
          return law.rated_torque();
        else
          return 0;
      },
      motor);
}

void check_motor(const Motor& motor) {
  std::visit([](const auto& law) { check(law); }, motor);
}

}  // namespace gyro
