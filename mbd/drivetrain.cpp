// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/drivetrain.hpp"

#include "core/base/errors.hpp"

#include <cmath>
#include <stdexcept>

namespace gyro {
namespace {

/// Below this turn of the wall in a window, work / angle is no longer trusted [rad]. It is 2 nm at
/// a mantle's circumference, so the energy left uncounted is at most 1e-9 rad x torque.
constexpr double smallest_turn = 1e-9;

bool same(const Window& a, const Window& b) {
  return a.first_step == b.first_step && a.steps == b.steps && a.dt == b.dt;
}

ShaftMotion motion_of(const DrivetrainState& state) {
  return {state.speed, static_cast<int>(state.direction)};
}

}  // namespace

Drivetrain::Drivetrain(const DrivetrainParameters& parameters) : parameters_(parameters), shaft_(parameters) {
  state_.angle = state_.wall_angle = parameters.start_angle;
  if (parameters.start == DrivetrainStart::running) {
    state_.speed = idle_speed(parameters);
    state_.direction = +1;
  }
  state_.start_energy = kinetic_energy();
}

MantlePath Drivetrain::predict(const Window& window) {
  predicted_ = window;
  MantlePath path{.angle = state_.wall_angle, .spin_angle = state_.spin_angle, .spin = state_.spin};
  if (shaft_.constant_speed()) {
    path.angle = parameters_.start_angle + state_.speed * window.begin();
    path.speed = state_.speed;
  } else {
    ShaftMotion motion = motion_of(state_);
    const ShaftTurn ahead = shaft_.turn(window.length(), state_.rock_torque, motion);
    // A stuck shaft holds the wall where it is, a hair from its own angle: closing that gap would
    // move a wall that must stand still.
    const bool still = ahead.angle == 0 && motion.direction == 0;
    path.speed = still ? 0 : (state_.angle + ahead.angle - state_.wall_angle) / window.length();
  }
  path_angle_ = path.speed * window.length();
  state_.wall_angle = path.angle + path_angle_;
  return path;
}

double Drivetrain::mean_rock_torque(const MantleLoad& load) const {
  if (!std::isfinite(load.work) || !std::isfinite(load.resisting_torque))
    throw StoppedByGuard("the load of the rock on the mantle is not finite; check the time step and the rock");
  return std::abs(path_angle_) > smallest_turn ? load.work / path_angle_ : load.resisting_torque;
}

void Drivetrain::advance(const Window& window, const MantleLoad& load) {
  if (!predicted_ || !same(*predicted_, window))
    throw std::logic_error("drivetrain: advance() on a window not predicted");
  const double rock_torque = mean_rock_torque(load);
  const double length = window.length();
  ShaftMotion motion = motion_of(state_);
  const ShaftTurn turn = shaft_.turn(length, rock_torque, motion);
  predicted_.reset();

  if (turn.stopped_after >= 0 && !stalled()) state_.stall_time = window.begin() + turn.stopped_after;
  state_.time = window.end();
  state_.angle =
      shaft_.constant_speed() ? parameters_.start_angle + state_.speed * window.end() : state_.angle + turn.angle;
  state_.speed = motion.speed;
  state_.direction = motion.direction;
  state_.rock_torque = rock_torque;
  state_.motor_work += turn.motor_work;
  state_.loss_work += turn.loss_work;
  state_.rock_work += load.work;

  means_.eccentric_speed = turn.angle / length;
  means_.motor_speed = parameters_.gear_ratio * means_.eccentric_speed;
  means_.motor_torque = turn.motor_impulse / length;
  means_.mantle_torque = rock_torque;
  means_.motor_power = turn.motor_work / length;
  means_.loss_power = turn.loss_work / length;
  means_.crushing_power = load.work / length;
  means_.power_residual = (turn.motor_work - turn.loss_work - load.work - turn.kinetic_gain) / length;
}

void Drivetrain::restore(const DrivetrainState& state) {
  state_ = state;
  predicted_.reset();
}

double Drivetrain::motor_torque() const {
  return shaft_.motor_torque_now(motion_of(state_), state_.rock_torque);
}

double Drivetrain::energy_residual() const {
  return state_.motor_work - state_.loss_work - state_.rock_work - (kinetic_energy() - state_.start_energy);
}

std::optional<double> Drivetrain::stall_time() const {
  return stalled() ? std::optional(state_.stall_time) : std::nullopt;
}

}  // namespace gyro
