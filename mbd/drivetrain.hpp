// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/window.hpp"
#include "mbd/drive.hpp"

#include <array>
#include <memory>
#include <optional>

namespace gyro {

/// What the rock did to the drive in a window.
struct MantleLoad {
  double work = 0;  ///< done by the mantle on the rock [J]
  /// Mean torque of the rock about the eccentric's axis, positive when it resists forward motion
  /// [N m]: T_c = -M_O . (z - (z.u) u), with M_O the rock's moment on the mantle about the pivot and u
  /// the mantle's axis. Asked for only while the mantle stands still, where work says nothing.
  double resisting_torque = 0;
  double spin_torque = 0;    ///< mean of M_O . u: of the rock on the mantle about its own axis [N m]
  BearingForces bearings{};  ///< [N]
};

/// Everything the drivetrain carries from window to window, as plain numbers: a checkpoint saves
/// and restores it bit for bit.
struct DrivetrainState {
  double time = 0;             ///< [s]
  double angle = 0;            ///< of the eccentric, continuous over turns [rad]
  double speed = 0;            ///< of the eccentric [rad/s]
  double direction = 0;        ///< +1 forward, 0 stuck, -1 backward
  double wall_angle = 0;       ///< eccentric angle to which the last predicted path has led [rad]
  double rock_torque = 0;      ///< of the last window; the next prediction holds it [N m]
  double spin_angle = 0;       ///< of the mantle about its own axis [rad]
  double spin = 0;             ///< [rad/s]; 0 where the mantle has no inertia of its own
  double slip = 0;             ///< of the mantle in the eccentric: 0 dragged along, +1 ahead, -1 lags
  double wall_spin_angle = 0;  ///< spin angle to which the last predicted path has led [rad]
  double spin_torque = 0;      ///< of the last window [N m]
  double bushing_force = 0;    ///< of the last window [N]
  double spider_force = 0;     ///< of the last window [N]
  double motor_speed = 0;      ///< with a coupling spring [rad/s]
  double twist = 0;            ///< of the coupling spring, at the motor's shaft [rad]
  double stall_time = -1;      ///< first halt of forward motion against the motor's torque [s]; < 0: none so far
  double motor_work = 0;       ///< of the motor on its shaft, since time 0 [J]
  double loss_work = 0;        ///< in bushings, bearings, gear, coupling and brake, since time 0 [J]
  double rock_work = 0;        ///< of the mantle on the rock, as the DEM counted it, since time 0 [J]
  double window_divisor = 1;   ///< power of 2 by which windows should be shorter than asked
  double residual_mean = 0;    ///< |power residual|, running mean since the divisor changed [W]
  double passed_mean = 0;      ///< largest power of the exchange, likewise [W]
  double windows_judged = 0;   ///< since the divisor changed
  double start_energy = 0;     ///< kinetic, and of the coupling spring, at time 0 [J]
  SwitchState motor{};
  static constexpr std::size_t max_events = 32;
  double events = 0;  ///< so far; the first most_events are kept
  std::array<double, max_events> event_time{}, event_kind{};
};

/// Means over the last window, for the series. Speeds are in DrivetrainState.
struct DrivetrainMeans {
  double motor_torque = 0;    ///< at the motor's shaft [N m]
  double mantle_torque = 0;   ///< of the rock at the eccentric, positive when it resists [N m]
  double motor_power = 0;     ///< mechanical, at the motor's shaft [W]
  double loss_power = 0;      ///< [W]
  double crushing_power = 0;  ///< from the mantle to the rock [W]
  /// Motor power - losses - crushing power - gain of kinetic energy [W]: what the exchange of held
  /// values creates or destroys. Falls with the square of the window; large against the crushing
  /// power means that the window is too long for the rock's stiffness and the inertia. NaN for a drive that does not
  /// say what it takes.
  double power_residual = 0;
};

/// The drivetrain as the DEM meets it: it leads with a path, and answers to the load on that path.
///
///   path = predict(window);  load = DEM along path;  advance(window, load)
///
/// 1. predict integrates the equation of motion over the window with the last window's load. The wall
///    moves at constant speed from where it is to that angle, so its pose never jumps.
/// 2. The DEM's work on this path, divided by the angle of the path, is the mean torque of the rock.
/// 3. advance integrates the same window again from the present state with that torque.
/// The wall lags the shaft by no more than one prediction error, which the next path makes good.
/// The exchange is of second order in the window's length for smooth loads.
class Drivetrain {
 public:
  /// At time 0, at start_angle; running at idle_speed, or at rest.
  /// @throws BadInput as check_drivetrain
  explicit Drivetrain(const DrivetrainParameters& parameters);
  /// The same for any drive. @param residual_limit  see DrivetrainParameters
  Drivetrain(std::unique_ptr<Drive> drive, double residual_limit);

  /// Path of the mantle over the window; exactly still while the shaft is stuck.
  MantlePath predict(const Window& window);

  /// @param window  the one just predicted
  /// @throws StoppedByGuard when the load is not finite; std::logic_error on a window not predicted
  void advance(const Window& window, const MantleLoad& load);

  const DrivetrainState& state() const { return state_; }
  /// Why a run with this drive has no checkpoints; empty when it has.
  std::string unsaveable() const { return drive_->unsaveable(); }
  /// What its drive has to save beyond state().
  std::vector<std::uint8_t> drive_state() const { return drive_->save(); }
  /// Goes on from a checkpoint of a drivetrain with the same parameters.
  /// @throws BadInput for the state of another drive
  void restore(const DrivetrainState& state, std::span<const std::uint8_t> drive_state = {});

  const DrivetrainMeans& means() const { return means_; }                 ///< over the last window
  double idle_speed() const { return drive_->idle_speed(); }              ///< of the eccentric without rock [rad/s]
  DriveKnowledge knows() const { return drive_->knows(); }                ///< which of the means are known
  std::vector<std::string> take_notes() { return drive_->take_notes(); }  ///< of the drive, for the log
  double motor_speed() const;                                             ///< now [rad/s]
  double motor_torque() const;                                            ///< now, at the motor's shaft [N m]
  double motor_power() const { return motor_torque() * motor_speed(); }   ///< now, mechanical [W]
  double kinetic_energy() const;                                          ///< now, with the coupling spring's [J]
  /// Motor work - losses - rock work - gain of kinetic energy, since time 0 [J].
  double energy_residual() const;
  /// How many times shorter than the case asks the next window should be: a power of 2. It doubles while
  /// the running mean of |power residual| / exchanged power is above residual_limit, and falls again once it has been
  /// below a sixteenth of it for as long (the residual goes with the square of the window).
  int window_divisor() const { return static_cast<int>(state_.window_divisor); }
  bool stuck() const { return state_.direction == 0; }     ///< stands still now
  bool stalled() const { return state_.stall_time >= 0; }  ///< forward motion has come to a halt at least once
  std::optional<double> stall_time() const;                ///< of the first stall [s]
  std::vector<DriveEvent> events() const;                  ///< the first most_events of the run

 private:
  /// Rock torque from the work along the path, or as given when the path has no length.
  double mean_rock_torque(const MantleLoad& load) const;
  ShaftMotion motion() const;
  void set_motion(const ShaftMotion& motion);
  ShaftLoad last_load() const;
  void take_up(const Window& window, const ShaftTurn& turn, const ShaftMotion& motion);
  void keep(const DriveEvent& event);
  void judge_window(const ShaftTurn& turn, double work, double length);

  std::unique_ptr<Drive> drive_;
  double residual_limit_;
  DrivetrainState state_;
  DrivetrainMeans means_;
  std::optional<Window> predicted_;              ///< window whose load is awaited
  double path_angle_ = 0, path_spin_angle_ = 0;  ///< turned by the wall in it [rad]
};

}  // namespace gyro
