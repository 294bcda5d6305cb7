// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/drivetrain_parameters.hpp"

#include "core/base/errors.hpp"

#include <cmath>
#include <string>

namespace gyro {
namespace {

double no_load_speed(const Motor& motor) {
  return std::visit([](const auto& law) { return law.no_load_speed(); }, motor);
}

/// Torque of the motor less the losses, at the eccentric, without rock, while it turns forward [N m].
double idle_surplus(const DrivetrainParameters& parameters, double motor_speed) {
  const double driving = parameters.transmission().torque_at_eccentric(motor_torque(parameters.motor, motor_speed), +1);
  return driving - parameters.eccentric_losses().torque(motor_speed / parameters.gear_ratio, +1, 0);
}

/// Halves [driving, braking] until neighbouring numbers are left.
double zero_surplus(const DrivetrainParameters& parameters, double driving, double braking) {
  for (;;) {
    const double middle = driving + (braking - driving) / 2;
    if (middle == driving || middle == braking) return middle;
    (idle_surplus(parameters, middle) > 0 ? driving : braking) = middle;
  }
}

void require(bool good, const std::string& problem) {
  if (!good) throw BadInput("drivetrain: " + problem);
}

bool at_least_zero(double value) {
  return std::isfinite(value) && value >= 0;
}

}  // namespace

Losses DrivetrainParameters::eccentric_losses() const {
  const double rated = std::visit([](const auto& law) { return law.rated_speed(); }, motor);
  return {losses, rated / gear_ratio};
}

double idle_speed(const DrivetrainParameters& parameters) {
  const double highest = no_load_speed(parameters.motor);
  if (std::holds_alternative<ConstantSpeedMotor>(parameters.motor)) return highest / parameters.gear_ratio;
  if (idle_surplus(parameters, highest) >= 0) return highest / parameters.gear_ratio;

  // From the top downwards: the first balance met is the stable one on the steep branch.
  constexpr int scan_points = 2000;
  double braking = highest;
  for (int k = scan_points - 1; k >= 0; --k) {
    const double speed = highest * k / scan_points;
    if (idle_surplus(parameters, speed) > 0) return zero_surplus(parameters, speed, braking) / parameters.gear_ratio;
    braking = speed;
  }
  throw BadInput(
      "drivetrain: the losses without rock are more than the motor can carry at any speed; accepted are "
      "losses below the motor's largest torque");
}

void check_drivetrain(const DrivetrainParameters& parameters) {
  const DrivetrainParameters& p = parameters;
  check_motor(p.motor);
  require(std::isfinite(p.gear_ratio) && p.gear_ratio > 0, "gear_ratio is not > 0; accepted is a number > 0");
  require(p.gear_efficiency > 0 && p.gear_efficiency <= 1, "gear_efficiency is outside (0, 1]; accepted is e.g. 0.96");
  require(at_least_zero(p.motor_inertia), "motor inertia is negative or not a number; accepted is a number >= 0");
  require(at_least_zero(p.eccentric_inertia),
          "eccentric inertia is negative or not a number; accepted is a number >= 0");
  require(p.effective_inertia() > 0, "all inertias are 0; accepted is a sum > 0");
  require(at_least_zero(p.losses.no_load_power), "no_load is negative or not a number; accepted is a power >= 0");
  require(at_least_zero(p.losses.load_factor), "load_factor is negative or not a number; accepted is a number >= 0");
  require(at_least_zero(p.losses.viscous), "viscous is negative or not a number; accepted is a number >= 0");
  require(std::isfinite(p.start_angle), "start angle is not a number; accepted is a finite angle");

  const bool ideal = std::holds_alternative<ConstantSpeedMotor>(p.motor);
  if (p.start == DrivetrainStart::running) {
    idle_speed(p);
  } else {
    require(!ideal, "a constant-speed motor cannot start from rest; accepted is start: running");
    require(idle_surplus(p, 0) > 0,
            "the motor's torque at standstill is not above the losses, so it would never start; accepted are smaller "
            "losses, a motor curve with more starting torque, or start: running");
  }
}

}  // namespace gyro
