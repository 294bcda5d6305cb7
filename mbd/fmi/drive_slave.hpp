// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/fmi/drive_variable.hpp"
#include "mbd/shaft.hpp"

#include <array>
#include <optional>

namespace gyro {

/// The state that changes while the drivetrain is stepped.
struct SlaveState {
  ShaftMotion motion{};
  ShaftLoad load{};                                                          ///< the inputs
  double angle = 0;                                                          ///< of the eccentric [rad]
  double spin_angle = 0;                                                     ///< of the mantle about its own axis [rad]
  double motor_angle = 0, motor_impulse = 0, motor_work = 0, loss_work = 0;  ///< since the start [rad], [N m s], [J]
  double begin = 0;                                                          ///< of the run [s]
  int stalls = 0, events = 0;
  static constexpr std::size_t kept_events = 8;
  std::array<double, kept_events> event_time{}, event_kind{};  ///< time [s] and kind of the last ones, the latest first
};

/// Calls f with each number of a state.
template <class State, class F>
void for_each_number(State& s, F&& f) {
  auto& m = s.motion;
  f(m.speed), f(m.direction), f(m.spin), f(m.slip), f(m.motor_speed), f(m.twist), f(m.time);
  auto& w = m.motor;
  f(w.sense), f(w.last_sense), f(w.heat), f(w.armed), f(w.slow_since), f(w.restart_at), f(w.restarts);
  f(s.load.rock_torque), f(s.load.spin_torque), f(s.load.bearings.bushing), f(s.load.bearings.spider);
  f(s.angle), f(s.spin_angle), f(s.motor_angle), f(s.motor_impulse), f(s.motor_work), f(s.loss_work);
  f(s.begin), f(s.stalls), f(s.events);
  for (auto& time : s.event_time) f(time);
  for (auto& kind : s.event_kind) f(kind);
}

/// The drivetrain as a co-simulation slave: it advances by a step under a given load. It keeps no accounts of the
/// exchange; the master does. The C functions of FMI are a thin layer over this class (fmi2_functions.cpp).
class DriveSlave {
 public:
  explicit DriveSlave(const DrivetrainParameters& parameters);
  DriveSlave(const DriveSlave&) = delete;  // its variables refer to it
  DriveSlave& operator=(const DriveSlave&) = delete;

  /// Parameters, inputs and outputs. Inputs that the parameters at construction do not use are left out: the spin's
  /// torque without mantle inertia, the forces on the bearings without friction there.
  const std::vector<DriveVariable>& variables() const { return variables_; }

  /// Applies changed parameters and sets the state at `time` [s]. @throws BadInput if the machine cannot start in the
  /// requested way
  void initialise(double time);
  /// @param time  where the step begins [s]
  /// @param duration  of the step, > 0 [s]
  /// @return events in the step, with times since the start of the run
  /// @throws StoppedByGuard if the drivetrain cannot be integrated
  std::vector<DriveEvent> step(double time, double duration);

  const SlaveState& state() const { return state_; }
  /// Values of all parameters, in their order.
  std::vector<double> parameter_values() const;
  /// Continues from a state with these parameters.
  void restore(const SlaveState& state, const std::vector<double>& parameter_values);

 private:
  void add_inputs();
  void add_outputs();
  void add_event_outputs();
  void keep(const DriveEvent& event);
  double motor_torque() const { return shaft_->motor_torque_now(state_.motion, state_.load); }

  DrivetrainParameters parameters_;
  std::vector<DriveVariable> variables_;
  std::size_t parameter_count_ = 0;
  std::optional<Shaft> shaft_;
  SlaveState state_;
};

}  // namespace gyro
