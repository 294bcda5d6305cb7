// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/bearings.hpp"
#include "mbd/losses.hpp"
#include "mbd/motor.hpp"
#include "mbd/protection.hpp"
#include "mbd/transmission.hpp"

namespace gyro {

/// How the machine is at time 0.
enum class DrivetrainStart {
  running,  ///< at idle_speed(), where the motor just carries the losses without rock
  rest      ///< at standstill; the motor is switched on at time 0
};

/// Compliance between motor and pinion. stiffness 0: a rigid shaft.
struct CouplingSpring {
  double stiffness = 0;  ///< at the motor's shaft, >= 0 [N m/rad]
  double damping = 0;    ///< likewise, >= 0 [N m s/rad]
};

/// Supply of the motor / rated voltage over time: linear between the points, constant after the last. Without points it
/// is 1.
struct VoltageInput {
  std::vector<double> times;   ///< increasing, the first 0 [s]
  std::vector<double> ratios;  ///< as many, >= 0 [-]

  double at(double time) const;
  bool changes() const { return times.size() > 1; }
};

/// All parameters of the drivetrain, in SI units, angles in rad.
struct DrivetrainParameters {
  Motor motor{};
  double gear_ratio = 1;         ///< motor speed / eccentric speed, > 0 [-]
  double gear_efficiency = 1;    ///< of the power that passes the gear, either way, 0 < eff <= 1 [-]
  double motor_inertia = 0;      ///< motor, coupling and pinion, about the motor shaft, >= 0 [kg m2]
  double eccentric_inertia = 0;  ///< eccentric and bevel gear, about the machine's axis, >= 0 [kg m2]
  LossParameters losses{};
  DrivetrainStart start = DrivetrainStart::running;
  double start_angle = 0;     ///< eccentric angle at time 0 [rad]
  double mantle_inertia = 0;  ///< mantle with its shaft, about its own axis; 0: it does not spin [kg m2]
  Bearings bearings{};
  CouplingSpring spring{};
  VoltageInput voltage{};
  ProtectionParameters protection{};
  double residual_limit = 0;  ///< share of the exchanged power beyond which windows are halved; 0: never [-]

  /// J_eff = J_eccentric + i^2 J_motor, seen at the eccentric [kg m2].
  double effective_inertia() const { return eccentric_inertia + gear_ratio * gear_ratio * motor_inertia; }
  Transmission transmission() const { return {gear_ratio, gear_efficiency}; }
  /// The losses as torques, with T_0 = no_load_power / (rated motor speed / i).
  Losses eccentric_losses() const;
  /// Of the name plate, or the one given for the relays [N m].
  double rated_motor_torque() const;
};

/// Rotation of the mantle in the idle crusher and the torque of its bearings, in closed form.
struct IdleMantle {
  double spin_ratio = 0;  ///< sigma / w [-]
  int slip = 0;           ///< 0: dragged along with the eccentric; -1: lags
  double torque = 0;      ///< of all bearings at the eccentric, at any speed [N m]
};
IdleMantle idle_mantle(const DrivetrainParameters& parameters);

/// Speed of the eccentric at which the motor just carries the losses without rock [rad/s].
/// @throws BadInput when the losses are more than the motor can carry
double idle_speed(const DrivetrainParameters& parameters);

/// @throws BadInput when a value is out of its range, or the machine cannot start in the requested way: the losses are
/// too large for the motor, or a constant-speed motor would start from rest
void check_drivetrain(const DrivetrainParameters& parameters);

}  // namespace gyro
