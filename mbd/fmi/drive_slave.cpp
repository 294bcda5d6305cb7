// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/fmi/drive_slave.hpp"

#include <algorithm>

namespace gyro {

DriveSlave::DriveSlave(const DrivetrainParameters& parameters)
    : parameters_(parameters), variables_(parameter_variables(parameters_)), parameter_count_(variables_.size()) {
  initialise(0);
  add_inputs();
  add_outputs();
  add_event_outputs();
}

void DriveSlave::add_inputs() {
  const auto add = [&](const char* name, const char* unit, double& field, const char* description) {
    variables_.push_back({name, VariableType::real, Causality::input, unit, description, [&field] { return field; },
                          [&field](double value) { field = value; }});
  };
  ShaftLoad& load = state_.load;
  add("mantle_torque", "N.m", load.rock_torque,
      "of the rock about the eccentric's axis; positive: resists forward motion");
  if (parameters_.mantle_inertia > 0)
    add("spin_torque", "N.m", load.spin_torque, "of the rock on the mantle about its own axis");
  const Bearings& b = parameters_.bearings;
  if (!(b.outer.friction > 0 || b.inner.friction > 0 || b.spider.friction > 0)) return;
  add("bushing_force", "N", load.bearings.bushing, "of the rock on the eccentric's bushings");
  add("spider_force", "N", load.bearings.spider, "of the rock on the spider, across the mantle's axis");
}

void DriveSlave::add_outputs() {
  const auto add = [&](const char* name, const char* unit, std::function<double()> get, const char* description,
                       VariableType type = VariableType::real) {
    variables_.push_back({name, type, Causality::output, unit, description, std::move(get), {}});
  };
  const auto motor_speed = [this] { return shaft_->motor_speed(state_.motion); };
  add(
      "eccentric_angle", "rad", [this] { return state_.angle; }, "of the eccentric, continuous over revolutions");
  add(
      "eccentric_speed", "rad/s", [this] { return state_.motion.speed; }, "of the eccentric");
  add(
      "mantle_spin_angle", "rad", [this] { return state_.spin_angle; }, "of the mantle about its own axis");
  add(
      "mantle_spin", "rad/s", [this] { return state_.motion.spin; }, "of the mantle about its own axis");
  add(
      "motor_angle", "rad", [this] { return state_.motor_angle; }, "by which the motor has turned since the start");
  add("motor_speed", "rad/s", motor_speed, "of the motor's shaft");
  add(
      "motor_torque", "N.m", [this] { return motor_torque(); }, "at the motor's shaft, positive forward");
  add(
      "motor_power", "W", [this, motor_speed] { return motor_torque() * motor_speed(); }, "mechanical, at its shaft");
  add(
      "motor_impulse", "N.m.s", [this] { return state_.motor_impulse; }, "integral of the motor's torque");
  add(
      "motor_work", "J", [this] { return state_.motor_work; }, "of the motor since the start");
  add(
      "loss_work", "J", [this] { return state_.loss_work; }, "in bearings, gear, coupling and brake since the start");
  add(
      "kinetic_energy", "J", [this] { return shaft_->energy(state_.motion); },
      "including the energy of the coupling spring");
}

void DriveSlave::add_event_outputs() {
  const auto add = [&](const std::string& name, VariableType type, auto get, const char* description) {
    variables_.push_back({name, type, Causality::output, type == VariableType::real ? "s" : "", description, get, {}});
  };
  add(
      "stalled", VariableType::boolean, [this] { return state_.stalls > 0 ? 1.0 : 0.0; },
      "has come to a halt against the torque of its motor");
  add(
      "tripped", VariableType::boolean, [this] { return state_.motion.motor.sense == 0 ? 1.0 : 0.0; },
      "a relay has switched the motor off");
  add(
      "events", VariableType::integer, [this] { return static_cast<double>(state_.events); },
      "number of stalls, trips and restarts so far");
  for (std::size_t k = 0; k < SlaveState::kept_events; ++k) {
    const std::string number = std::to_string(k + 1) + ']';
    add(
        "event_time[" + number, VariableType::real, [this, k] { return state_.event_time[k]; },
        "time of the event; [1] is the latest");
    add(
        "event_kind[" + number, VariableType::integer, [this, k] { return state_.event_kind[k]; },
        "0 none, 1 stall, 2 turned back, 3 standstill, 4 overload trip, 5 instantaneous trip, 6 under-speed trip, "
        "7 restart, 8 reversed restart, 9 held");
  }
}

void DriveSlave::keep(const DriveEvent& event) {
  SlaveState& s = state_;
  std::shift_right(s.event_time.begin(), s.event_time.end(), 1);
  std::shift_right(s.event_kind.begin(), s.event_kind.end(), 1);
  s.event_time[0] = event.time;
  s.event_kind[0] = static_cast<double>(event.kind);
  s.stalls += event.kind == DriveEventKind::stall;
  ++s.events;
}

void DriveSlave::initialise(double time) {
  complete_motor(parameters_.motor);
  check_drivetrain(parameters_);
  const ShaftLoad load = state_.load;  // inputs may have been set before
  shaft_.emplace(parameters_);
  state_ = {.motion = shaft_->start(), .load = load, .angle = parameters_.start_angle};
  state_.motion.time = state_.begin = time;
}

std::vector<DriveEvent> DriveSlave::step(double time, double duration) {
  SlaveState& s = state_;
  s.motion.time = time;
  ShaftAdvance gained = shaft_->advance(duration, s.load, s.motion);
  s.angle = shaft_->constant_speed() ? parameters_.start_angle + s.motion.speed * (time + duration - s.begin)
                                     : s.angle + gained.angle;
  s.spin_angle += gained.spin_angle;
  s.motor_angle += gained.motor_angle;
  s.motor_impulse += gained.motor_impulse;
  s.motor_work += gained.motor_work;
  s.loss_work += gained.loss_work;
  for (const DriveEvent& event : gained.events) keep(event);
  return std::move(gained.events);
}

std::vector<double> DriveSlave::parameter_values() const {
  std::vector<double> values;
  for (std::size_t k = 0; k < parameter_count_; ++k) values.push_back(variables_[k].get());
  return values;
}

void DriveSlave::restore(const SlaveState& state, const std::vector<double>& values) {
  if (values != parameter_values()) {
    for (std::size_t k = 0; k < parameter_count_; ++k) variables_[k].set(values.at(k));
    initialise(state.motion.time);
  }
  state_ = state;
}

}  // namespace gyro
