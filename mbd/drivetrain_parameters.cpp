// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/drivetrain_parameters.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace gyro {
namespace {

/// Torque of the motor less the losses, at the eccentric, without rock, while it turns forward [N m].
double idle_surplus(const DrivetrainParameters& parameters, double motor_speed) {
  const double at_motor = motor_torque(parameters.motor, motor_speed, parameters.voltage.at(0));
  return parameters.transmission().torque_at_eccentric(at_motor, +1) -
         parameters.eccentric_losses().torque(motor_speed / parameters.gear_ratio, +1, 0) -
         idle_mantle(parameters).torque;
}

/// Motor speed of zero surplus in [driving, braking], to the last bit, by bisection [rad/s].
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

void check_bearings(const DrivetrainParameters& p) {
  bool any = false;
  for (const Bearing* bearing : {&p.bearings.outer, &p.bearings.inner, &p.bearings.spider}) {
    require(at_least_zero(bearing->friction) && at_least_zero(bearing->radius) && at_least_zero(bearing->idle_force),
            "a bearing's friction, radius or idle_force is negative or not a number; they must be numbers >= 0");
    any = any || bearing->friction > 0;
  }
  require(
      !any || (std::isfinite(p.bearings.depth) && p.bearings.depth > 0),
      "the bearings have friction, but the depth of the bushings below the pivot is not > 0; it must be a length > 0");
  require(p.bearings.tilt_sine >= 0 && p.bearings.tilt_sine < 1,
          "the sine of the mantle's tilt is outside [0, 1); it is eccentricity / pivot height");
  require(at_least_zero(p.mantle_inertia), "mantle inertia is negative or not a number; it must be a number >= 0");
}

void check_supply(const DrivetrainParameters& p) {
  const VoltageInput& v = p.voltage;
  require(v.times.size() == v.ratios.size(),
          "the voltage has different numbers of times and ratios; give one ratio per time");
  require(std::ranges::all_of(v.ratios, at_least_zero), "a voltage is negative or not a number; it must be >= 0");
  require(v.times.empty() || v.times.front() == 0, "the voltage does not begin at time 0; its first time must be 0");
  require(std::ranges::adjacent_find(v.times, [](double a, double b) { return !(a < b); }) == v.times.end(),
          "the times of the voltage do not increase; each must be later than the one before");
  const bool ideal = std::holds_alternative<ConstantSpeedMotor>(p.motor);
  require(!ideal || v.times.empty(),
          "a constant-speed motor has no voltage; use another motor, or leave the voltage out");
  require(!ideal || p.spring.stiffness == 0,
          "a constant-speed motor has no coupling spring; use another motor, or leave the spring out");
  require(at_least_zero(p.spring.stiffness) && at_least_zero(p.spring.damping),
          "the coupling spring's stiffness or damping is negative or not a number; both must be numbers >= 0");
  require(p.spring.stiffness == 0 || (p.motor_inertia > 0 && p.eccentric_inertia > 0),
          "a coupling spring needs an inertia on either side; the inertias of motor and eccentric must be > 0");
}

void check_protection(const DrivetrainParameters& p) {
  const ProtectionParameters& r = p.protection;
  if (!r.any()) return;
  require(!std::holds_alternative<ConstantSpeedMotor>(p.motor),
          "a constant-speed motor has no relays; use another motor, or leave the protection out");
  for (const double value :
       {r.overload_time, r.instantaneous_ratio, r.under_speed_delay, r.brake_torque, r.restart_delay, r.rated_torque})
    require(at_least_zero(value), "a value of the protection is negative or not a number; it must be >= 0");
  require(std::isfinite(r.overload_ratio) && r.overload_ratio > 0, "overload_ratio is not > 0; usual is 1.05");
  require(r.under_speed >= 0 && r.under_speed < 1, "under_speed is outside [0, 1); a usual value is 0.5");
  require(r.restarts >= 0, "restarts is negative; it must be >= 0");
  require((r.overload_time == 0 && r.instantaneous_ratio == 0) || p.rated_motor_torque() > 0,
          "relays that measure the current need the rated_torque of a motor without a name plate");
}

}  // namespace

double VoltageInput::at(double time) const {
  if (times.empty()) return 1;
  const auto next = std::ranges::upper_bound(times, time);
  if (next == times.end()) return ratios.back();
  const std::size_t k = static_cast<std::size_t>(next - times.begin());
  if (k == 0) return ratios.front();
  return ratios[k - 1] + (ratios[k] - ratios[k - 1]) * (time - times[k - 1]) / (times[k] - times[k - 1]);
}

double DrivetrainParameters::rated_motor_torque() const {
  const double rated = rated_torque_of(motor);
  return rated > 0 ? rated : protection.rated_torque;
}

IdleMantle idle_mantle(const DrivetrainParameters& p) {
  const double outer = p.bearings.outer.torque(0), inner = p.bearings.inner.torque(0);
  const double spider = p.bearings.spider.torque(0), sine = p.bearings.tilt_sine;
  const double cosine = std::sqrt((1 - sine) * (1 + sine));
  if (!(p.mantle_inertia > 0)) return {0, -1, outer + inner * cosine + spider * sine};
  if (inner >= spider * cosine) return {cosine, 0, outer + spider};
  // The mantle lags: the spider's torque about the mantle's axis equals the torque that the bushing transmits.
  const double share = inner / spider, across = std::sqrt(1 - share * share);
  return {sine * share / across, -1, outer + inner * cosine + spider * sine * across};
}

Losses DrivetrainParameters::eccentric_losses() const {
  return {losses, rated_speed(motor) / gear_ratio};
}

double idle_speed(const DrivetrainParameters& parameters) {
  const double highest = no_load_speed(parameters.motor);
  if (std::holds_alternative<ConstantSpeedMotor>(parameters.motor)) return highest / parameters.gear_ratio;
  if (idle_surplus(parameters, highest) >= 0) return highest / parameters.gear_ratio;

  // Scan from the highest speed downwards: the first balance found is the stable one on the steep branch.
  constexpr int scan_points = 2000;
  double braking = highest;
  for (int k = scan_points - 1; k >= 0; --k) {
    const double speed = highest * k / scan_points;
    if (idle_surplus(parameters, speed) > 0) return zero_surplus(parameters, speed, braking) / parameters.gear_ratio;
    braking = speed;
  }
  throw BadInput(
      "drivetrain: the losses without rock are more than the motor can carry at any speed; reduce them "
      "below the motor's largest torque, and check its unit: a curve is in N m, not in percent");
}

void check_drivetrain(const DrivetrainParameters& parameters) {
  const DrivetrainParameters& p = parameters;
  check_motor(p.motor);
  require(std::isfinite(p.gear_ratio) && p.gear_ratio > 0, "gear_ratio is not > 0; it must be a number > 0");
  require(p.gear_efficiency > 0 && p.gear_efficiency <= 1, "gear_efficiency is outside (0, 1]; a usual value is 0.96");
  require(at_least_zero(p.motor_inertia), "motor inertia is negative or not a number; it must be a number >= 0");
  require(at_least_zero(p.eccentric_inertia),
          "eccentric inertia is negative or not a number; it must be a number >= 0");
  require(p.effective_inertia() > 0, "all inertias are 0; their sum must be > 0");
  require(at_least_zero(p.losses.no_load_power), "no_load is negative or not a number; it must be a power >= 0");
  require(at_least_zero(p.losses.load_factor), "load_factor is negative or not a number; it must be a number >= 0");
  require(at_least_zero(p.losses.viscous), "viscous is negative or not a number; it must be a number >= 0");
  require(std::isfinite(p.start_angle), "the start angle is not a number; it must be finite");

  check_bearings(p);
  check_supply(p);
  check_protection(p);

  const bool ideal = std::holds_alternative<ConstantSpeedMotor>(p.motor);
  if (p.start == DrivetrainStart::running) {
    idle_speed(p);
  } else {
    require(!ideal, "a constant-speed motor cannot start from rest; use start: running");
    require(idle_surplus(p, 0) > 0,
            "the motor's torque at standstill is not above the losses, so it would never start; use "
            "smaller losses, a motor with more starting torque, or start: running");
  }
}

}  // namespace gyro
