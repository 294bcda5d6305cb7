// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/drivetrain.hpp"

#include "core/base/errors.hpp"
#include "mbd/shaft.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gyro {
namespace {

/// Below this turn of the wall in a window, work / angle is no longer trusted [rad]. It is 2 nm at
/// a mantle's circumference, so the energy left uncounted is at most 1e-9 rad x torque.
constexpr double smallest_turn = 1e-9;

bool same(const Window& a, const Window& b) {
  return a.first_step == b.first_step && a.steps == b.steps && a.dt == b.dt;
}

}  // namespace

Drivetrain::Drivetrain(const DrivetrainParameters& parameters)
    : Drivetrain(std::make_unique<Shaft>(parameters), parameters.residual_limit) {}

Drivetrain::Drivetrain(std::unique_ptr<Drive> drive, double residual_limit)
    : drive_(std::move(drive)), residual_limit_(drive_->knows().accounts ? residual_limit : 0) {
  state_.angle = state_.wall_angle = drive_->start_angle();
  set_motion(drive_->start());
  state_.start_energy = kinetic_energy();
}

ShaftMotion Drivetrain::motion() const {
  const DrivetrainState& s = state_;
  return {s.speed, static_cast<int>(s.direction), s.spin, static_cast<int>(s.slip), s.motor_speed, s.twist, s.time,
          s.motor};
}

void Drivetrain::set_motion(const ShaftMotion& motion) {
  state_.speed = motion.speed;
  state_.direction = motion.direction;
  state_.spin = motion.spin;
  state_.slip = motion.slip;
  state_.motor_speed = motion.motor_speed;
  state_.twist = motion.twist;
  state_.motor = motion.motor;
}

ShaftLoad Drivetrain::last_load() const {
  return {state_.rock_torque, state_.spin_torque, {state_.bushing_force, state_.spider_force}};
}

MantlePath Drivetrain::predict(const Window& window) {
  predicted_ = window;
  const double length = window.length();
  MantlePath path{.angle = state_.wall_angle, .spin_angle = state_.wall_spin_angle, .spin = state_.spin};
  ShaftMotion ahead = motion();
  const ShaftTurn turn = drive_->preview(length, last_load(), ahead);
  if (drive_->constant_speed()) {
    path.angle = drive_->start_angle() + state_.speed * window.begin();
    path.speed = state_.speed;
  } else {
    // A stuck shaft holds the wall where it is, a hair from its own angle: closing that gap would
    // move a wall that must stand still.
    const bool still = turn.angle == 0 && ahead.direction == 0;
    path.speed = still ? 0 : (state_.angle + turn.angle - state_.wall_angle) / length;
  }
  const bool spinless = turn.spun == 0 && ahead.spin == 0;
  path.spin = spinless ? 0 : (state_.spin_angle + turn.spun - state_.wall_spin_angle) / length;
  path_angle_ = path.speed * length;
  path_spin_angle_ = path.spin * length;
  state_.wall_angle = path.angle + path_angle_;
  state_.wall_spin_angle = path.spin_angle + path_spin_angle_;
  return path;
}

/// The power of the rock is T_c theta' - T_s sigma; the spin's share is taken out before the rest is a torque.
double Drivetrain::mean_rock_torque(const MantleLoad& load) const {
  for (const double value :
       {load.work, load.resisting_torque, load.spin_torque, load.bearings.bushing, load.bearings.spider})
    if (!std::isfinite(value))
      throw StoppedByGuard("the load of the rock on the mantle is not finite; check the time step and the rock");
  if (std::abs(path_angle_) <= smallest_turn) return load.resisting_torque;
  return (load.work + load.spin_torque * path_spin_angle_) / path_angle_;
}

void Drivetrain::advance(const Window& window, const MantleLoad& load) {
  if (!predicted_ || !same(*predicted_, window))
    throw std::logic_error("drivetrain: advance() on a window not predicted");
  state_.rock_torque = mean_rock_torque(load);
  state_.spin_torque = load.spin_torque;
  state_.bushing_force = load.bearings.bushing;
  state_.spider_force = load.bearings.spider;
  ShaftMotion moved = motion();
  const ShaftTurn turn = drive_->turn(window.length(), last_load(), moved);
  predicted_.reset();
  state_.rock_work += load.work;
  take_up(window, turn, moved);
  means_.crushing_power = load.work / window.length();
  means_.power_residual = (turn.motor_work - turn.loss_work - load.work - turn.kinetic_gain) / window.length();
  if (!drive_->knows().accounts) means_.power_residual = std::numeric_limits<double>::quiet_NaN();
  judge_window(turn, load.work, window.length());
}

/// Running means over some 16 windows: one impact is no reason.
void Drivetrain::judge_window(const ShaftTurn& turn, double work, double length) {
  constexpr double memory = 1.0 / 16;
  constexpr double max_divisor = 256;
  if (!(residual_limit_ > 0)) return;
  const double passed = std::max({std::abs(turn.motor_work), std::abs(work), std::abs(turn.kinetic_gain)}) / length;
  state_.residual_mean += memory * (std::abs(means_.power_residual) - state_.residual_mean);
  state_.passed_mean += memory * (passed - state_.passed_mean);
  ++state_.windows_judged;
  if (state_.windows_judged < 1 / memory) return;             // since the last change
  const double rounding = 1e-12 * kinetic_energy() / length;  // of an idle drive
  const double limit = residual_limit_ * state_.passed_mean + rounding;
  const double divisor = state_.window_divisor;
  if (state_.residual_mean > limit && divisor < max_divisor) state_.window_divisor *= 2;
  if (state_.residual_mean < limit / 16 && divisor > 1) state_.window_divisor /= 2;
  if (state_.window_divisor == divisor) return;
  state_.residual_mean = state_.passed_mean = state_.windows_judged = 0;
}

void Drivetrain::take_up(const Window& window, const ShaftTurn& turn, const ShaftMotion& moved) {
  for (const DriveEvent& event : turn.events) keep(event);
  set_motion(moved);
  state_.time = window.end();
  state_.angle =
      drive_->constant_speed() ? drive_->start_angle() + state_.speed * window.end() : state_.angle + turn.angle;
  state_.spin_angle += turn.spun;
  state_.motor_work += turn.motor_work;
  state_.loss_work += turn.loss_work;
  const double length = window.length();
  means_.motor_torque = turn.motor_impulse / length;
  means_.mantle_torque = state_.rock_torque;
  means_.motor_power = turn.motor_work / length;
  means_.loss_power = turn.loss_work / length;
}

void Drivetrain::keep(const DriveEvent& event) {
  const auto number = static_cast<std::size_t>(state_.events);
  if (number < DrivetrainState::max_events) {
    state_.event_time[number] = event.time;
    state_.event_kind[number] = static_cast<double>(event.kind);
  }
  ++state_.events;
  if (event.kind == DriveEventKind::stall && !stalled()) state_.stall_time = event.time;
}

std::vector<DriveEvent> Drivetrain::events() const {
  std::vector<DriveEvent> kept;
  for (std::size_t k = 0; k < DrivetrainState::max_events && static_cast<double>(k) < state_.events; ++k)
    kept.push_back({state_.event_time[k], static_cast<DriveEventKind>(static_cast<int>(state_.event_kind[k]))});
  return kept;
}

void Drivetrain::restore(const DrivetrainState& state, std::span<const std::uint8_t> drive_state) {
  drive_->restore(drive_state);
  state_ = state;
  predicted_.reset();
}

double Drivetrain::motor_speed() const {
  return drive_->motor_speed(motion());
}

double Drivetrain::kinetic_energy() const {
  return drive_->energy(motion());
}

double Drivetrain::motor_torque() const {
  return drive_->motor_torque_now(motion(), last_load());
}

double Drivetrain::energy_residual() const {
  return state_.motor_work - state_.loss_work - state_.rock_work - (kinetic_energy() - state_.start_energy);
}

std::optional<double> Drivetrain::stall_time() const {
  return stalled() ? std::optional(state_.stall_time) : std::nullopt;
}

}  // namespace gyro
