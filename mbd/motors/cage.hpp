// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <complex>

namespace gyro {

/// One cage of a rotor: Kloss's curve through its own breakdown.
struct Cage {
  double breakdown_torque = 0;  ///< Tk [N m]
  double breakdown_slip = 0;    ///< sk [-]

  /// T = 2 Tk s sk / (s^2 + sk^2) at slip s [N m].
  double torque(double slip) const {
    return 2 * breakdown_torque * slip * breakdown_slip / (slip * slip + breakdown_slip * breakdown_slip);
  }
  /// Rotor current Tk s / (sk + j s), times a constant that all cages of a rotor share.
  std::complex<double> current(double slip) const {
    return breakdown_torque * slip / std::complex<double>(breakdown_slip, slip);
  }
};

/// Slip s = (synchronous speed - speed) / synchronous speed [-].
inline double slip_at(double speed, double synchronous_speed) {
  return (synchronous_speed - speed) / synchronous_speed;
}

}  // namespace gyro
