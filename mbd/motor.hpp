// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/motors/constant_speed.hpp"
#include "mbd/motors/curve.hpp"
#include "mbd/motors/double_cage.hpp"
#include "mbd/motors/droop.hpp"
#include "mbd/motors/induction.hpp"

#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// All motor laws: quasi-static torque at the motor shaft against the shaft's speed. A positive torque drives forward;
/// a negative one brakes a motor that turns forward (generator). Electrical transients (about 10 ms) are left out.
///
/// A law is a struct in mbd/motors with
///
///   model                            its name in case files and exported FMUs
///   for_each_parameter(f, motor)     calls f(key, unit, field, description) for each parameter the user gives
///   check()                          throws BadInput for a parameter that is out of range
///   torque(speed, voltage)           [N m], continuous in the speed [rad/s]; voltage / rated voltage [-]
///   no_load_speed(), rated_speed()   [rad/s]: of zero torque; at which the user's losses are quoted
///   complete()                       optional: computes the derived parameters
///   rated_torque(), current(speed)   optional: of a name plate [N m]; current / rated current at rated voltage [-]
/// To add a law: add its file in mbd/motors, its type in this list, and its keys in io/schema/drivetrain_keys.cpp.
using Motor = std::variant<InductionMotor, DoubleCageMotor, DroopMotor, CurveMotor, ConstantSpeedMotor>;

/// The name of a motor's law.
std::string model_of(const Motor& motor);
/// All names, in the order of the list.
std::vector<std::string> motor_models();
/// A motor of this law, without parameters. @throws BadInput for an unknown name
Motor motor_of_model(const std::string& model);
/// Calls f(key, unit, field, description) for each parameter; fields are numbers or lists of numbers.
template <class F>
void for_each_parameter(F&& f, Motor& motor) {
  std::visit([&](auto& law) { law.for_each_parameter(f, law); }, motor);
}
/// Computes the derived parameters; call it after any parameter has changed. @throws BadInput if no motor has them
void complete_motor(Motor& motor);
/// @throws BadInput when a parameter of the motor is out of its range
void check_motor(const Motor& motor);

/// Torque at a speed of the motor's shaft [N m]; 0 for the ideal drive, which has no law.
/// @param voltage  / rated voltage [-]
double motor_torque(const Motor& motor, double speed, double voltage = 1);

/// Current / rated current [-]: of the rotor for motors with a name plate; |torque| / rated_torque for the others.
double motor_current(const Motor& motor, double speed, double voltage, double rated_torque);

/// Speed at which the torque falls to zero at rated voltage [rad/s].
double no_load_speed(const Motor& motor);
/// Speed at which the losses are quoted [rad/s].
double rated_speed(const Motor& motor);
/// Rated torque of a motor with a name plate [N m]; 0 for the others.
double rated_torque_of(const Motor& motor);

}  // namespace gyro
