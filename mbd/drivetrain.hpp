// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/window.hpp"
#include "mbd/drive.hpp"
#include "mbd/mantle_load.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace gyro {

/// State that the drivetrain carries from window to window.
struct DrivetrainState {
  double time = 0;             ///< [s]
  double angle = 0;            ///< of the eccentric, counts revolutions [rad]
  double speed = 0;            ///< of the eccentric [rad/s]
  int direction = 0;           ///< +1 forward, 0 stuck, -1 backward
  double wall_angle = 0;       ///< eccentric angle at the end of the last predicted path [rad]
  double rock_torque = 0;      ///< of the last window; the next prediction holds it [N m]
  double spin_angle = 0;       ///< of the mantle about its own axis [rad]
  double spin = 0;             ///< [rad/s]; 0 where the mantle has no inertia of its own
  int slip = 0;                ///< of the mantle in the eccentric: 0 dragged along, +1 ahead, -1 lags
  double wall_spin_angle = 0;  ///< spin angle at the end of the last predicted path [rad]
  double spin_torque = 0;      ///< of the last window [N m]
  double bushing_force = 0;    ///< of the last window [N]
  double spider_force = 0;     ///< of the last window [N]
  double motor_speed = 0;      ///< with a coupling spring [rad/s]
  double twist = 0;            ///< of the coupling spring, at the motor's shaft [rad]
  double stall_time = -1;      ///< first halt of forward motion against the motor's torque [s]; < 0: none so far
  double motor_work = 0;       ///< of the motor on its shaft, since time 0 [J]
  double loss_work = 0;        ///< in bushings, bearings, gear, coupling and brake, since time 0 [J]
  double rock_work = 0;        ///< of the mantle on the rock, as the DEM counted it, since time 0 [J]
  int window_divisor = 1;      ///< windows should be shorter than requested by this power of 2
  double residual_mean = 0;    ///< |power residual|, running mean since the divisor changed [W]
  double exchanged_mean = 0;   ///< largest power of the exchange, likewise [W]
  int windows_judged = 0;      ///< since the divisor changed
  double start_energy = 0;     ///< kinetic, and of the coupling spring, at time 0 [J]
  SwitchState motor{};
  std::int64_t events = 0;               ///< so far
  std::vector<double> event_time;        ///< of the first max_events [s]
  std::vector<std::int32_t> event_kind;  ///< DriveEventKind of each
  static constexpr std::size_t max_events = 32;

  /// Calls f(name, field) for every field, to be read or filled.
  template <class F, class S>
  static constexpr void for_each_field(F&& f, S& s) {
    f("time", s.time);
    f("angle", s.angle);
    f("speed", s.speed);
    f("direction", s.direction);
    f("wall_angle", s.wall_angle);
    f("rock_torque", s.rock_torque);
    f("spin_angle", s.spin_angle);
    f("spin", s.spin);
    f("slip", s.slip);
    f("wall_spin_angle", s.wall_spin_angle);
    f("spin_torque", s.spin_torque);
    f("bushing_force", s.bushing_force);
    f("spider_force", s.spider_force);
    f("motor_speed", s.motor_speed);
    f("twist", s.twist);
    f("stall_time", s.stall_time);
    f("motor_work", s.motor_work);
    f("loss_work", s.loss_work);
    f("rock_work", s.rock_work);
    f("window_divisor", s.window_divisor);
    f("residual_mean", s.residual_mean);
    f("exchanged_mean", s.exchanged_mean);
    f("windows_judged", s.windows_judged);
    f("start_energy", s.start_energy);
    f("motor", s.motor);
    f("events", s.events);
    f("event_time", s.event_time);
    f("event_kind", s.event_kind);
  }
};

/// Means over the last window, for the series. Speeds are in DrivetrainState.
struct DrivetrainMeans {
  double motor_torque = 0;    ///< at the motor's shaft [N m]
  double mantle_torque = 0;   ///< of the rock at the eccentric, positive when it resists [N m]
  double motor_power = 0;     ///< mechanical, at the motor's shaft [W]
  double loss_power = 0;      ///< [W]
  double crushing_power = 0;  ///< from the mantle to the rock [W]
  /// Motor power - losses - crushing power - gain of kinetic energy [W]: the error of the exchange of held values. It
  /// falls with the square of the window. A value that is large against the crushing power means that the window is too
  /// long for the rock's stiffness and the inertia. NaN for a drive that does not give its accounts.
  double power_residual = 0;
};

/// How a drive is coupled to the rock.
struct DriveCoupling {
  double residual_limit = 0;  ///< see DrivetrainParameters [-]
  double bushing_depth = 0;   ///< of the bushings below the pivot [m]; 0: bearing forces are not used
};

/// The drivetrain as the DEM sees it: it predicts a path of the mantle, and responds to the load on that path.
///
///   path = predict(window);  load = DEM along path;  advance(window, load)
///
/// 1. predict integrates the equation of motion over the window with the last window's load. The wall moves at constant
///    speed from where it is to that angle, so its pose never jumps.
/// 2. The DEM's work on this path, divided by the angle of the path, is the mean torque of the rock.
/// 3. advance integrates the same window again from the present state with that torque.
/// The wall lags the shaft by at most one prediction error, which the next path makes up for. The exchange is of second
/// order in the window's length for smooth loads.
class Drivetrain {
 public:
  /// At time 0, at start_angle; running at idle_speed, or at rest.
  /// @throws BadInput as check_drivetrain
  explicit Drivetrain(const DrivetrainParameters& parameters);
  /// With any drive, in its start state.
  Drivetrain(std::unique_ptr<Drive> drive, const DriveCoupling& coupling);

  /// Path of the mantle over the window; exactly still while the shaft is stuck.
  MantlePath predict(const Window& window);

  /// @param window  the one just predicted
  /// @throws StoppedByGuard when the load is not finite; std::logic_error for a window that was not predicted
  void advance(const Window& window, const MantleLoad& load);

  const DrivetrainState& state() const { return state_; }
  /// Reason why a run with this drive has no checkpoints; empty if it has.
  std::string unsaveable() const { return drive_->unsaveable(); }
  /// State of the drive that is not in state().
  std::vector<std::uint8_t> drive_state() const { return drive_->save(); }
  /// Continues from the state of a drivetrain with the same parameters.
  /// @throws BadInput for the state of another drive
  void restore(const DrivetrainState& state, std::span<const std::uint8_t> drive_state = {});

  const DrivetrainMeans& means() const { return means_; }                 ///< over the last window
  double bushing_depth() const { return coupling_.bushing_depth; }        ///< see DriveCoupling [m]
  double idle_speed() const { return drive_->idle_speed(); }              ///< of the eccentric without rock [rad/s]
  DriveKnowledge knows() const { return drive_->knows(); }                ///< which of the means are known
  std::vector<std::string> take_notes() { return drive_->take_notes(); }  ///< of the drive, for the log
  double motor_speed() const;                                             ///< now [rad/s]
  double motor_torque() const;                                            ///< now, at the motor's shaft [N m]
  double motor_power() const { return motor_torque() * motor_speed(); }   ///< now, mechanical [W]
  double kinetic_energy() const;                                          ///< now, with the coupling spring's [J]
  /// Motor work - losses - rock work - gain of kinetic energy, since time 0 [J].
  double energy_residual() const;
  /// How many times shorter than requested the next window should be: a power of 2. It is doubled while the running
  /// mean of |power residual| / exchanged power is above residual_limit, and halved once that mean has been below a
  /// sixteenth of the limit for the same time (the residual is proportional to the square of the window).
  int window_divisor() const { return state_.window_divisor; }
  bool stuck() const { return state_.direction == 0; }     ///< stands still now
  bool stalled() const { return state_.stall_time >= 0; }  ///< forward motion has come to a halt at least once
  std::optional<double> stall_time() const;                ///< of the first stall [s]
  std::vector<DriveEvent> events() const;                  ///< the first max_events of the run

 private:
  /// Rock torque from the work along the path, or the given mean torque if the path has no length [N m].
  double mean_rock_torque(const MantleLoad& load) const;
  ShaftMotion motion() const;
  void set_motion(const ShaftMotion& motion);
  ShaftLoad last_load() const;
  void apply(const Window& window, const ShaftAdvance& gained, const ShaftMotion& motion);
  void keep(const DriveEvent& event);
  void judge_window(const ShaftAdvance& gained, double work, double length);

  std::unique_ptr<Drive> drive_;
  DriveCoupling coupling_;
  DrivetrainState state_;
  DrivetrainMeans means_;
  std::optional<Window> predicted_;              ///< predicted window that has not been advanced yet
  double path_angle_ = 0, path_spin_angle_ = 0;  ///< of the wall in it [rad]
};

}  // namespace gyro
