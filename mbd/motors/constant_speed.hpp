// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/motors/check.hpp"

namespace gyro {

/// Ideal drive: the shaft turns at this speed under any load; ShaftModel computes the torque that the load requires.
struct ConstantSpeedMotor {
  static constexpr const char* model = "constant_speed";

  double speed = 0;  ///< of the motor shaft, > 0 [rad/s]

  template <class F, class Self>
  static void for_each_parameter(F&& f, Self& m) {
    f("speed", "rad/s", m.speed, "speed of the motor");
  }
  void check() const { require_positive(speed, "speed"); }

  double torque(double, double) const { return 0; }
  double no_load_speed() const { return speed; }
  double rated_speed() const { return speed; }
};

}  // namespace gyro
