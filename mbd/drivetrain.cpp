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

/// Angle of the wall in a window below which work / angle is too inaccurate to be a torque [rad]. It is 2 nm at a
/// mantle's circumference, so the energy that is not counted is at most 1e-9 rad x torque.
constexpr double min_path_angle = 1e-9;

bool same(const Window& a, const Window& b) {
  return a.first_step == b.first_step && a.steps == b.steps && a.dt == b.dt;
}

}  // namespace

Drivetrain::Drivetrain(const DrivetrainParameters& parameters)
    : Drivetrain(std::make_unique<Shaft>(parameters), {parameters.residual_limit, parameters.bearings.depth}) {}

Drivetrain::Drivetrain(std::unique_ptr<Drive> drive, const DriveCoupling& coupling)
    : drive_(std::move(drive)), coupling_(coupling) {
  if (!drive_->knows().accounts) coupling_.residual_limit = 0;
  state_.angle = state_.wall_angle = drive_->start_angle();
  set_motion(drive_->start());
  state_.start_energy = kinetic_energy();
}

ShaftMotion Drivetrain::motion() const {
  const DrivetrainState& s = state_;
  return {s.speed, s.direction, s.spin, s.slip, s.motor_speed, s.twist, s.time, s.motor};
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
  const ShaftAdvance gained = drive_->preview(length, last_load(), ahead);
  if (drive_->constant_speed()) {
    path.angle = drive_->start_angle() + state_.speed * window.begin();
    path.speed = state_.speed;
  } else {
    // A stuck shaft holds the wall where it is, which may differ from the shaft's own angle by rounding: closing that
    // gap would move a wall that must stand still.
    const bool still = gained.angle == 0 && ahead.direction == 0;
    path.speed = still ? 0 : (state_.angle + gained.angle - state_.wall_angle) / length;
  }
  const bool spinless = gained.spin_angle == 0 && ahead.spin == 0;
  path.spin = spinless ? 0 : (state_.spin_angle + gained.spin_angle - state_.wall_spin_angle) / length;
  path_angle_ = path.speed * length;
  path_spin_angle_ = path.spin * length;
  state_.wall_angle = path.angle + path_angle_;
  state_.wall_spin_angle = path.spin_angle + path_spin_angle_;
  return path;
}

/// The mantle's power on the rock is T_c theta' - T_s sigma: T_c is the work without the share of the spin, by angle.
double Drivetrain::mean_rock_torque(const MantleLoad& load) const {
  for (const double value :
       {load.work, load.resisting_torque, load.spin_torque, load.bearings.bushing, load.bearings.spider})
    if (!std::isfinite(value))
      throw StoppedByGuard("the load of the rock on the mantle is not finite; check the time step and the rock");
  if (std::abs(path_angle_) <= min_path_angle) return load.resisting_torque;
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
  const ShaftAdvance gained = drive_->advance(window.length(), last_load(), moved);
  predicted_.reset();
  state_.rock_work += load.work;
  apply(window, gained, moved);
  means_.crushing_power = load.work / window.length();
  means_.power_residual = (gained.motor_work - gained.loss_work - load.work - gained.kinetic_gain) / window.length();
  if (!drive_->knows().accounts) means_.power_residual = std::numeric_limits<double>::quiet_NaN();
  judge_window(gained, load.work, window.length());
}

/// Uses running means over about 16 windows, so that a single impact does not change the divisor.
void Drivetrain::judge_window(const ShaftAdvance& gained, double work, double length) {
  constexpr double memory = 1.0 / 16;
  constexpr int max_divisor = 256;
  if (!(coupling_.residual_limit > 0)) return;
  const double exchanged =
      std::max({std::abs(gained.motor_work), std::abs(work), std::abs(gained.kinetic_gain)}) / length;
  state_.residual_mean += memory * (std::abs(means_.power_residual) - state_.residual_mean);
  state_.exchanged_mean += memory * (exchanged - state_.exchanged_mean);
  ++state_.windows_judged;
  if (state_.windows_judged < 1 / memory) return;             // since the last change
  const double rounding = 1e-12 * kinetic_energy() / length;  // of an idle drive
  const double limit = coupling_.residual_limit * state_.exchanged_mean + rounding;
  const int divisor = state_.window_divisor;
  if (state_.residual_mean > limit && divisor < max_divisor) state_.window_divisor *= 2;
  if (state_.residual_mean < limit / 16 && divisor > 1) state_.window_divisor /= 2;
  if (state_.window_divisor == divisor) return;
  state_.residual_mean = state_.exchanged_mean = 0;
  state_.windows_judged = 0;
}

void Drivetrain::apply(const Window& window, const ShaftAdvance& gained, const ShaftMotion& moved) {
  for (const DriveEvent& event : gained.events) keep(event);
  set_motion(moved);
  state_.time = window.end();
  state_.angle =
      drive_->constant_speed() ? drive_->start_angle() + state_.speed * window.end() : state_.angle + gained.angle;
  state_.spin_angle += gained.spin_angle;
  state_.motor_work += gained.motor_work;
  state_.loss_work += gained.loss_work;
  const double length = window.length();
  means_.motor_torque = gained.motor_impulse / length;
  means_.mantle_torque = state_.rock_torque;
  means_.motor_power = gained.motor_work / length;
  means_.loss_power = gained.loss_work / length;
}

void Drivetrain::keep(const DriveEvent& event) {
  if (state_.event_time.size() < DrivetrainState::max_events) {
    state_.event_time.push_back(event.time);
    state_.event_kind.push_back(static_cast<std::int32_t>(event.kind));
  }
  ++state_.events;
  if (event.kind == DriveEventKind::stall && !stalled()) state_.stall_time = event.time;
}

std::vector<DriveEvent> Drivetrain::events() const {
  std::vector<DriveEvent> kept;
  for (std::size_t k = 0; k < state_.event_time.size(); ++k)
    kept.push_back({state_.event_time[k], static_cast<DriveEventKind>(state_.event_kind[k])});
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
