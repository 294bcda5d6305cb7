// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/motors/cage.hpp"

namespace gyro {

/// Induction motor after Kloss (1916), from the figures of its name plate.
///
///   T(s) = 2 Tb s sb / (s^2 + sb^2),   s = 1 - speed / synchronous_speed
///   Tb = breakdown_ratio TN,  TN = rated_power / ((1 - sN) synchronous_speed)
///   sb = sN (lambda + sqrt(lambda^2 - 1)),  lambda = breakdown_ratio
///
/// so that T(sN) = TN. This form has no 0/0 at s = 0 and holds on every branch: s < 0 brakes (generator), 0 < s < 1
/// drives, s > 1 is a shaft that turns backwards (plugging). The torque is proportional to the voltage squared.
/// Limit: the stator's resistance is left out, so the starting torque 2 Tb / (sb + 1/sb) is lower (0.4 TN for sN 1.67
/// %, lambda 2.5) than that of real crusher motors (about 2 TN, NEMA C). Use a DoubleCageMotor where the start under
/// load matters.
struct InductionMotor {
  static constexpr const char* model = "induction";

  double rated_power = 0;        ///< mechanical, at the shaft [W]
  double synchronous_speed = 0;  ///< [rad/s]
  double rated_slip = 0;         ///< sN, 0 < sN < 1 [-]
  double breakdown_ratio = 0;    ///< lambda, largest torque / rated torque, > 1 [-]

  template <class F, class Self>
  static void for_each_parameter(F&& f, Self& m) {
    f("rated_power", "W", m.rated_power, "mechanical power at rated slip");
    f("synchronous_speed", "rad/s", m.synchronous_speed, "speed of zero torque");
    f("rated_slip", "", m.rated_slip, "1 - rated speed / synchronous speed");
    f("breakdown_ratio", "", m.breakdown_ratio, "pull-out torque / rated torque");
  }
  void check() const;

  double torque(double speed, double voltage = 1) const;
  /// Current / rated current: |s / (sb + j s)| over its value at rated slip. The magnetising current is left out, so it
  /// is 0 at synchronous speed, where a real motor takes a third of its rated current.
  double current(double speed) const;
  double no_load_speed() const { return synchronous_speed; }
  double rated_speed() const { return (1 - rated_slip) * synchronous_speed; }

  double rated_torque() const;      ///< TN [N m]
  double breakdown_torque() const;  ///< Tb [N m]
  double breakdown_slip() const;    ///< sb [-]
};

}  // namespace gyro
