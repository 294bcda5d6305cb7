// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// The rigid bevel gear between motor shaft and eccentric. The share 1 - efficiency of the transmitted power is lost in
/// either direction of flow:
///
///   T_eccentric = i T_motor efficiency   while the motor drives (T_motor in the direction of motion)
///   T_eccentric = i T_motor / efficiency while the motor brakes
///
/// The inertia of the motor is reflected without this loss (error of order 1 - efficiency in i^2 J_motor).
struct Transmission {
  double ratio = 1;       ///< i, motor speed / eccentric speed [-]
  double efficiency = 1;  ///< [-]

  /// @param direction  +1 or -1: the way the shafts turn or start to turn
  double torque_at_eccentric(double motor_torque, int direction) const {
    return ratio * motor_torque * (motor_torque * direction > 0 ? efficiency : 1 / efficiency);
  }
  /// The inverse of torque_at_eccentric.
  double torque_at_motor(double eccentric_torque, int direction) const {
    return eccentric_torque / ratio / (eccentric_torque * direction > 0 ? efficiency : 1 / efficiency);
  }
};

}  // namespace gyro
