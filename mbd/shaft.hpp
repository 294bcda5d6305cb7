// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/cvode_session.hpp"
#include "mbd/drivetrain_parameters.hpp"

namespace gyro {

/// Motion of the eccentric at one moment.
struct ShaftMotion {
  double speed = 0;   ///< [rad/s]; exactly 0 when stuck
  int direction = 0;  ///< +1 forward, 0 stuck, -1 backward
};

/// What the shaft did in an interval.
struct ShaftTurn {
  double angle = 0;           ///< turned by the eccentric [rad]
  double speed_change = 0;    ///< of the eccentric [rad/s]
  double motor_impulse = 0;   ///< integral of the motor's torque over time, at its shaft [N m s]
  double motor_work = 0;      ///< of the motor on its shaft [J]
  double loss_work = 0;       ///< in bushings, bearings and gear [J]
  double kinetic_gain = 0;    ///< of kinetic energy [J]
  double stopped_after = -1;  ///< time at which forward motion came to a halt [s]; < 0 when it did not
};

/// The equation of motion of motor, gear and eccentric as one rigid shaft,
///
///   J_eff dw/dt = T_eccentric(i w) - T_rock - T_losses(w, T_rock),
///
/// under a load T_rock that is constant over the interval. Dry friction and gear losses jump at w = 0.
/// An automaton of three states keeps the equation smooth while it is integrated: forward and
/// backward fix the sign of the jumps and end at a root of w; there, and whenever w = 0, the shaft
///   starts forward   when the net torque with forward friction is > 0,
///   starts backward  when the net torque with backward friction is < 0,
///   stays stuck      otherwise: friction takes up the difference and the speed is exactly 0.
/// The two cannot hold at once, and under a constant load a shaft that has left 0 does not return in
/// the same interval, so there is no chatter.
class Shaft {
 public:
  /// @throws BadInput as check_drivetrain
  explicit Shaft(const DrivetrainParameters& parameters);
  Shaft(const Shaft&) = delete;  // the integrator calls back into this object
  Shaft& operator=(const Shaft&) = delete;

  /// Integrates over `duration` > 0 [s] under a constant load of the rock at the eccentric,
  /// `rock_torque` [N m], positive when it resists forward motion; changes `motion`.
  ShaftTurn turn(double duration, double rock_torque, ShaftMotion& motion);

  /// Kinetic energy of all that turns, at a speed of the eccentric [J].
  double kinetic_energy(double speed) const { return 0.5 * inertia_ * speed * speed; }
  /// Torque at the motor's shaft [N m]: the law's, or what the ideal drive needs under this load.
  double motor_torque_now(const ShaftMotion& motion, double rock_torque) const;
  /// True for the ideal drive, whose speed never changes.
  bool constant_speed() const { return std::holds_alternative<ConstantSpeedMotor>(motor_); }

 private:
  double motor_torque_at(double speed) const { return motor_torque(motor_, transmission_.ratio * speed); }
  double ideal_motor_torque(double speed, double rock_torque) const;
  double net_torque(double speed, int direction) const;
  int direction_from_standstill() const;
  void evaluate(std::span<const double> y, std::span<double> rate) const;
  double turn_smoothly(double duration, ShaftMotion& motion, ShaftTurn& sum);
  ShaftTurn turn_at_constant_speed(double duration, double speed) const;

  Motor motor_;
  Transmission transmission_;
  Losses losses_;
  double inertia_;
  // Of the leg that is being integrated:
  double rock_torque_ = 0, start_speed_ = 0;
  int direction_ = 0;
  CvodeSession session_;
};

}  // namespace gyro
