// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/induction.hpp"

#include <variant>
#include <vector>

// Motor laws: quasi-static torque at the motor shaft against the shaft's speed.
// Units: N m, rad/s, W. A positive torque drives forward; a negative one brakes a motor that
// turns forward (generator). The electrical transients of the motor (some 10 ms) are left out.

namespace gyro {

/// Motor whose torque falls on a straight line, as that of a DC machine at constant voltage:
///   T = stall_torque (1 - speed / synchronous_speed)
struct DroopMotor {
  double synchronous_speed = 0;  ///< speed of zero torque [rad/s]
  double stall_torque = 0;       ///< at standstill [N m]

  double torque(double speed) const { return stall_torque * (1 - speed / synchronous_speed); }
  double no_load_speed() const { return synchronous_speed; }
  double rated_speed() const { return synchronous_speed; }
};

/// The droop that the curves of Xiong et al. (Minerals 2024, 14, 774, Fig. 10) follow: at the
/// eccentric through (160 rpm, 0) and (125 rpm, 21 kN m), that is 5729.6 N m s/rad (16.755 rad/s - w),
/// 96 kN m at standstill; at the motor shaft, through the gear of 3.75: 600 rpm and 25.6 kN m.
DroopMotor paper_droop();

/// Motor given by a table, linear in between. Below the first speed the torque of the first point
/// is kept; above the last speed the line through the last two points goes on. So a catalogue curve
/// from standstill to the synchronous speed is complete: it brakes above, and pushes with its
/// locked-rotor torque when it is turned backwards.
struct CurveMotor {
  std::vector<double> speeds;   ///< increasing, the first <= 0 [rad/s]
  std::vector<double> torques;  ///< as many; the last <= 0, at least one > 0 [N m]

  double torque(double speed) const;
  double no_load_speed() const;  ///< highest speed at which the torque falls to zero [rad/s]
  double rated_speed() const { return no_load_speed(); }
};

/// Ideal drive: the eccentric turns at this speed whatever the load; the torque is what that takes.
struct ConstantSpeedMotor {
  double speed = 0;  ///< of the motor shaft, > 0 [rad/s]

  double no_load_speed() const { return speed; }
  double rated_speed() const { return speed; }
};

/// All motor laws there are.
using Motor = std::variant<InductionMotor, DoubleCageMotor, DroopMotor, CurveMotor, ConstantSpeedMotor>;

/// Torque of any motor at a speed of its shaft [N m]; 0 for the ideal drive, which has no law.
/// @param voltage  / rated voltage [-]. Torques of cage rotors and of tables go with its square. The droop
///                 is a line of constant slope, T = stall_torque (voltage - speed / synchronous_speed).
double motor_torque(const Motor& motor, double speed, double voltage = 1);

/// Current / rated current [-]: of the rotor for cage rotors; |torque| / rated_torque for the others.
double motor_current(const Motor& motor, double speed, double voltage, double rated_torque);

/// Rated torque of a motor with a name plate [N m]; 0 for the others.
double rated_torque_of(const Motor& motor);

/// @throws BadInput when a figure of the motor is out of its range
void check_motor(const Motor& motor);

}  // namespace gyro
