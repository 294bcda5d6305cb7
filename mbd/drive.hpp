// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/shaft_model.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Motion of the drive at one moment.
struct ShaftMotion {
  double speed = 0;        ///< of the eccentric [rad/s]; exactly 0 when stuck
  int direction = 0;       ///< +1 forward, 0 stuck, -1 backward
  double spin = 0;         ///< of the mantle about its own axis [rad/s]
  int slip = 0;            ///< 0: the mantle is dragged along by the eccentric; +1 it runs ahead, -1 it lags
  double motor_speed = 0;  ///< with a coupling spring; otherwise it follows from `speed` [rad/s]
  double twist = 0;        ///< of the coupling spring [rad]
  double time = 0;         ///< since the start of the run, for voltage and relays [s]
  SwitchState motor{};
};

/// What changed in an interval.
struct ShaftAdvance {
  double angle = 0;                ///< by which the eccentric turned [rad]
  double spin_angle = 0;           ///< by which the mantle turned about its own axis [rad]
  double motor_angle = 0;          ///< by which the motor turned [rad]
  double speed_change = 0;         ///< of the eccentric [rad/s]
  double motor_impulse = 0;        ///< integral of the motor's torque over time, at its shaft [N m s]
  double motor_work = 0;           ///< of the motor on its shaft [J]
  double loss_work = 0;            ///< in bushings, bearings, gear, coupling and brake [J]
  double kinetic_gain = 0;         ///< of kinetic energy, and of the coupling spring's [J]
  double stopped_after = -1;       ///< time from the start of the interval to the halt of forward motion [s]; < 0: none
  std::vector<DriveEvent> events;  ///< in order; times since the start of the run
};

/// Which quantities a drive can give. An FMU may give fewer than the built-in drive.
struct DriveKnowledge {
  bool motor_speed = true, motor_torque = true, motor_power = true;
  bool accounts = true;  ///< motor work, losses and kinetic energy, so that the exchange can be judged
};

/// The machine that moves the mantle against the rock's torque: the built-in Shaft, or an FMU (mbd/fmi). It is called
/// twice per window, so the cost of virtual calls is negligible.
class Drive {
 public:
  Drive() = default;
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;
  virtual ~Drive() = default;

  virtual ShaftMotion start() const = 0;   ///< motion at time 0
  virtual double start_angle() const = 0;  ///< of the eccentric at time 0 [rad]

  /// Returns what advance() would return, and changes only `motion`. Parameters as advance().
  virtual ShaftAdvance preview(double duration, const ShaftLoad& load, ShaftMotion& motion) = 0;
  /// Advances by `duration` > 0 [s] under a constant load.
  /// @param motion  as the last advance() left it; changed to that at the end
  /// @throws StoppedByGuard when the drive cannot be integrated
  virtual ShaftAdvance advance(double duration, const ShaftLoad& load, ShaftMotion& motion) = 0;

  virtual double energy(const ShaftMotion& motion) const = 0;       ///< kinetic, and stored in springs [J]
  virtual double motor_speed(const ShaftMotion& motion) const = 0;  ///< [rad/s]
  /// At the motor's shaft [N m].
  virtual double motor_torque_now(const ShaftMotion& motion, const ShaftLoad& load) const = 0;
  virtual double idle_speed() const = 0;                 ///< of the eccentric without rock [rad/s]
  virtual bool constant_speed() const { return false; }  ///< true for the ideal drive, whose speed never changes
  virtual DriveKnowledge knows() const { return {}; }

  /// Reason why its state cannot be saved; empty if it can.
  virtual std::string unsaveable() const { return {}; }
  /// State beyond ShaftMotion.
  virtual std::vector<std::uint8_t> save() const { return {}; }
  /// Continues from what save() returned. @throws BadInput for the state of another drive
  virtual void restore(std::span<const std::uint8_t>) {}
  /// Messages for the user since the last call.
  virtual std::vector<std::string> take_notes() { return {}; }
};

}  // namespace gyro
