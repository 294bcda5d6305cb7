// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/shaft.hpp"

#include "core/base/errors.hpp"

#include <array>

namespace gyro {
namespace {

// Unknowns of one leg. All are gains since its start, so that the tolerance is relative to the small
// change in an interval and neither to the speed nor to an angle that grows for ever. The integrals
// ride along, so that the energy balance is as good as the solution. The mantle's spin would be
// one more gain of speed, with its own line in Shaft::evaluate.
enum Unknown { turned, speed_gain, motor_impulse, motor_work, loss_work, unknowns };

// rad, rad/s, N m s, J, J: each some 1e-10 of what a window of 0.5 ms brings in a large crusher
constexpr std::array<double, unknowns> absolute_tolerance{1e-13, 1e-13, 1e-9, 1e-8, 1e-8};

constexpr int most_legs = 3;  // forward, backward, stuck

const DrivetrainParameters& checked(const DrivetrainParameters& parameters) {
  check_drivetrain(parameters);
  return parameters;
}

int sign(double value) {
  return (value > 0) - (value < 0);
}

}  // namespace

Shaft::Shaft(const DrivetrainParameters& parameters)
    : motor_(checked(parameters).motor),
      transmission_(parameters.transmission()),
      losses_(parameters.eccentric_losses()),
      inertia_(parameters.effective_inertia()),
      session_(
          {.size = unknowns, .absolute_tolerance = absolute_tolerance},
          [this](std::span<const double> y, std::span<double> rate) { evaluate(y, rate); },
          [this](std::span<const double> y) { return start_speed_ + y[speed_gain]; }) {}

double Shaft::net_torque(double speed, int direction) const {
  return transmission_.torque_at_eccentric(motor_torque_at(speed), direction) - rock_torque_ -
         losses_.torque(speed, direction, rock_torque_);
}

int Shaft::direction_from_standstill() const {
  if (net_torque(0, +1) > 0) return +1;
  if (net_torque(0, -1) < 0) return -1;
  return 0;
}

void Shaft::evaluate(std::span<const double> y, std::span<double> rate) const {
  const double speed = start_speed_ + y[speed_gain];
  const double at_motor = motor_torque_at(speed);
  const double net = net_torque(speed, direction_);
  const double motor_power = at_motor * transmission_.ratio * speed;
  rate[turned] = speed;
  rate[speed_gain] = net / inertia_;
  rate[motor_impulse] = at_motor;
  rate[motor_work] = motor_power;
  rate[loss_work] = motor_power - (net + rock_torque_) * speed;
}

/// One leg: as long as the direction lasts. @return its duration [s]
double Shaft::turn_smoothly(double duration, ShaftMotion& motion, ShaftTurn& sum) {
  start_speed_ = motion.speed;
  direction_ = motion.direction;
  std::array<double, unknowns> y{};
  const double lasted = session_.integrate(duration, y);
  const bool halted = lasted < duration;
  if (halted) y[speed_gain] = -start_speed_;  // exactly 0 at the root
  motion.speed = halted ? 0 : start_speed_ + y[speed_gain];
  sum.angle += y[turned];
  sum.speed_change += y[speed_gain];
  sum.motor_impulse += y[motor_impulse];
  sum.motor_work += y[motor_work];
  sum.loss_work += y[loss_work];
  sum.kinetic_gain += inertia_ * y[speed_gain] * (start_speed_ + y[speed_gain] / 2);
  return lasted;
}

ShaftTurn Shaft::turn(double duration, double rock_torque, ShaftMotion& motion) {
  rock_torque_ = rock_torque;
  if (constant_speed()) return turn_at_constant_speed(duration, motion.speed);
  ShaftTurn sum;
  double done = 0;
  for (int leg = 0; leg < most_legs; ++leg) {
    motion.direction = motion.speed == 0 ? direction_from_standstill() : sign(motion.speed);
    if (motion.direction == 0) {
      sum.motor_impulse += motor_torque_at(0) * (duration - done);
      return sum;
    }
    const double lasted = turn_smoothly(duration - done, motion, sum);
    if (lasted >= duration - done) return sum;
    done += lasted;
    if (motion.direction > 0) sum.stopped_after = done;
  }
  throw StoppedByGuard("the drivetrain reversed more than twice under a constant load; check motor and losses");
}

double Shaft::motor_torque_now(const ShaftMotion& motion, double rock_torque) const {
  return constant_speed() ? ideal_motor_torque(motion.speed, rock_torque) : motor_torque_at(motion.speed);
}

double Shaft::ideal_motor_torque(double speed, double rock_torque) const {
  return transmission_.torque_at_motor(rock_torque + losses_.torque(speed, +1, rock_torque), +1);
}

ShaftTurn Shaft::turn_at_constant_speed(double duration, double speed) const {
  const double at_motor = ideal_motor_torque(speed, rock_torque_);
  ShaftTurn turn;
  turn.angle = speed * duration;
  turn.motor_impulse = at_motor * duration;
  turn.motor_work = at_motor * transmission_.ratio * turn.angle;
  turn.loss_work = turn.motor_work - rock_torque_ * turn.angle;
  return turn;
}

}  // namespace gyro
