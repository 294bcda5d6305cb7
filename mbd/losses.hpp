// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace gyro {

/// Losses between motor shaft and rock, as the user specifies them.
struct LossParameters {
  double no_load_power = 0;  ///< of the idle crusher at rated speed, >= 0 [W]
  double load_factor = 0;    ///< share of the rock's torque lost in bushings and bearings, >= 0 [-]
  double viscous = 0;        ///< at the eccentric, >= 0 [N m s/rad]
};

/// The losses as a torque at the eccentric that opposes its motion:
///
///   T_losses(w, T_rock) = sign(w) (T_0 + load_factor |T_rock|) + viscous w
///
/// At standstill it is set-valued: the torque that balances the others, up to the magnitude dry_torque(). T_0 =
/// no_load_power / rated speed of the eccentric, the same at every speed. The load part follows Pc = P0 + zeta P_crush
/// as measured on cone crushers: bushings carry the crushing force, so their friction grows with it.
struct Losses {
  double constant_torque = 0;  ///< T_0 [N m]
  double load_factor = 0;      ///< [-]
  double viscous = 0;          ///< [N m s/rad]

  Losses(const LossParameters& parameters, double rated_eccentric_speed)
      : constant_torque(parameters.no_load_power / rated_eccentric_speed),
        load_factor(parameters.load_factor),
        viscous(parameters.viscous) {}

  /// Dry friction, which is also the largest torque that friction can hold at standstill [N m], >= 0.
  double dry_torque(double rock_torque) const { return constant_torque + load_factor * std::abs(rock_torque); }

  /// @param direction  +1 or -1: the way the eccentric turns or starts to turn
  double torque(double speed, int direction, double rock_torque) const {
    return direction * dry_torque(rock_torque) + viscous * speed;
  }
};

}  // namespace gyro
