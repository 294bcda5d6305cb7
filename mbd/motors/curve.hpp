// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace gyro {

/// Motor given by a table of torque against speed, linear between the points.
///
/// Below the first speed the torque of the first point holds; above the last speed the line through the last two points
/// continues. A catalogue curve from standstill to the synchronous speed is therefore complete: it brakes above, and
/// pushes with its locked-rotor torque when it is turned backwards. The torque is proportional to the voltage squared.
struct CurveMotor {
  static constexpr const char* model = "curve";

  std::vector<double> speeds;   ///< increasing, the first <= 0 [rad/s]
  std::vector<double> torques;  ///< one per speed; the last <= 0, at least one > 0 [N m]

  template <class F, class Self>
  static void for_each_parameter(F&& f, Self& m) {
    f("curve_speed", "rad/s", m.speeds, "speed of a point of the motor's curve");
    f("curve_torque", "N.m", m.torques, "torque of a point of the motor's curve");
  }
  void check() const;

  double torque(double speed, double voltage = 1) const;
  double no_load_speed() const;  ///< highest speed at which the torque falls to zero [rad/s]
  double rated_speed() const { return no_load_speed(); }
};

}  // namespace gyro
