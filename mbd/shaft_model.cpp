// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/shaft_model.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

double cosine(double sine) {
  return std::sqrt((1 - sine) * (1 + sine));
}

const DrivetrainParameters& checked(const DrivetrainParameters& parameters) {
  check_drivetrain(parameters);
  return parameters;
}

}  // namespace

ShaftModel::ShaftModel(const DrivetrainParameters& parameters)
    : motor_(checked(parameters).motor),
      ideal_(std::holds_alternative<ConstantSpeedMotor>(motor_)),
      rated_motor_torque_(parameters.rated_motor_torque()),
      transmission_(parameters.transmission()),
      losses_(parameters.eccentric_losses()),
      bearings_(parameters.bearings),
      spring_(parameters.spring),
      inertia_(has_spring() ? parameters.eccentric_inertia : parameters.effective_inertia()),
      motor_inertia_(has_spring() ? parameters.motor_inertia : 0),
      mantle_inertia_(parameters.mantle_inertia),
      cos_tilt_(cosine(parameters.bearings.tilt_sine)) {
  set_load({});
}

void ShaftModel::set_load(const ShaftLoad& load) {
  load_ = load;
  inner_torque_ = bearings_.inner.torque(load.bearings.bushing);
  spider_torque_ = bearings_.spider.torque(load.bearings.spider);
  dry_torque_ = losses_.dry_torque(load.rock_torque) + bearings_.outer.torque(load.bearings.bushing);
  if (!mantle_spins()) dry_torque_ += inner_torque_ * cos_tilt_ + spider_torque_ * bearings_.tilt_sine;
}

double ShaftModel::motor_torque_at(const ShaftPoint& now, double sense) const {
  return sense == 0 ? 0 : sense * motor_torque(motor_, sense * now.motor_speed, now.voltage);
}

double ShaftModel::motor_current_at(const ShaftPoint& now, double sense) const {
  return sense == 0 ? 0 : motor_current(motor_, sense * now.motor_speed, now.voltage, rated_motor_torque_);
}

/// Torque at the gear's input: that of the motor, or of the spring if there is one [N m].
double ShaftModel::input_torque(const ShaftPoint& now, double at_motor) const {
  if (!has_spring()) return at_motor;
  return spring_.stiffness * now.twist + spring_.damping * (now.motor_speed - transmission_.ratio * now.speed);
}

/// The spider's friction against Omega, as torques in the two equations of motion, and its power.
/// @param free_mantle_torque  on the mantle without the spider; at rest the spider balances it, up to its largest
/// torque
ShaftModel::Spider ShaftModel::spider(const ShaftPoint& now, FrictionSigns signs, double free_mantle_torque) const {
  const double sine = bearings_.tilt_sine;
  if (signs.slip == 0 && signs.direction != 0)  // Omega = w z
    return {spider_torque_ * signs.direction * sine * sine, spider_torque_ * signs.direction * cos_tilt_,
            spider_torque_ * std::abs(now.speed)};
  const double rate = std::hypot(now.speed * sine, now.spin);
  if (rate == 0) return {0, std::clamp(free_mantle_torque, -spider_torque_, spider_torque_), 0};
  return {spider_torque_ * now.speed * sine * sine / rate, spider_torque_ * now.spin / rate, spider_torque_ * rate};
}

/// Accelerations while the mantle is dragged along: one equation of motion for mantle and eccentric.
void ShaftModel::move_both(ShaftBalance& b, const Spider& held, double net) const {
  if (!ideal_)
    b.acceleration =
        (net + cos_tilt_ * (load_.spin_torque - held.on_mantle)) / (inertia_ + mantle_inertia_ * cos_tilt_ * cos_tilt_);
  b.spin_acceleration = cos_tilt_ * b.acceleration;
  b.bushing_torque = mantle_inertia_ * b.spin_acceleration - load_.spin_torque + held.on_mantle;
}

/// Ideal drive: the motor's torque that keeps the given speed.
void ShaftModel::drive_ideally(ShaftBalance& b, const ShaftPoint& now, const Spider& held, double dry) const {
  const double needed =
      load_.rock_torque + dry + losses_.viscous * now.speed + b.bushing_torque * cos_tilt_ + held.on_eccentric;
  b.motor_torque = transmission_.torque_at_motor(needed, +1);
}

ShaftBalance ShaftModel::balance(const ShaftPoint& now, FrictionSigns signs, double sense, double brake_torque) const {
  const int d = signs.direction;
  const bool dragged = signs.slip == 0;
  const double dry = dry_torque_ + transmission_.ratio * brake_torque;
  ShaftBalance b;
  b.motor_torque = motor_torque_at(now, sense);
  double input = input_torque(now, b.motor_torque);
  Spider held;
  if (mantle_spins()) {
    b.bushing_torque = -signs.slip * inner_torque_;
    held = spider(now, signs, load_.spin_torque + b.bushing_torque);
    if (dragged && d == 0) b.bushing_torque = held.on_mantle - load_.spin_torque;
    b.spin_acceleration = (load_.spin_torque + b.bushing_torque - held.on_mantle) / mantle_inertia_;
  }
  const auto net = [&](int direction) {
    return transmission_.torque_at_eccentric(input, direction) - load_.rock_torque - direction * dry -
           losses_.viscous * now.speed - b.bushing_torque * cos_tilt_ - held.on_eccentric;
  };
  b.stuck_forward = net(+1);
  b.stuck_backward = net(-1);
  if (d != 0 && !ideal_) b.acceleration = net(d) / inertia_;
  if (d != 0 && dragged && mantle_spins()) {
    b.bushing_torque = 0;
    move_both(b, held, net(d));
  }
  if (ideal_) {
    drive_ideally(b, now, held, dry);
    input = b.motor_torque;
  }
  b.motor_power = b.motor_torque * now.motor_speed;
  b.loss_power = losses_at(now, b, signs, input, dry) + held.power;
  if (has_spring()) b.motor_acceleration = (b.motor_torque - input) / motor_inertia_;
  return b;
}

/// All losses except the spider's [W].
double ShaftModel::losses_at(const ShaftPoint& now, const ShaftBalance& b, FrictionSigns signs, double input,
                             double dry) const {
  const double ratio = transmission_.ratio;
  const double out_of_gear = transmission_.torque_at_eccentric(input, signs.direction) * now.speed;
  double loss =
      input * ratio * now.speed - out_of_gear + (signs.direction * dry + losses_.viscous * now.speed) * now.speed;
  if (signs.slip != 0 && mantle_spins()) loss -= b.bushing_torque * (now.spin - cos_tilt_ * now.speed);
  if (has_spring()) {
    const double relative = now.motor_speed - ratio * now.speed;
    loss += spring_.damping * relative * relative;
  }
  return loss;
}

}  // namespace gyro
