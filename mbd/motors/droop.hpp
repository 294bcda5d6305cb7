// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// Motor whose torque falls on a straight line, as that of a DC machine:
///
///   T = stall_torque (voltage - speed / synchronous_speed),   voltage / rated voltage
///
/// so that a change of the voltage shifts the line and keeps its slope.
struct DroopMotor {
  static constexpr const char* model = "droop";

  double synchronous_speed = 0;  ///< speed of zero torque at rated voltage [rad/s]
  double stall_torque = 0;       ///< at standstill and rated voltage [N m]

  template <class F, class Self>
  static void for_each_parameter(F&& f, Self& m) {
    f("synchronous_speed", "rad/s", m.synchronous_speed, "speed of zero torque");
    f("stall_torque", "N.m", m.stall_torque, "torque at standstill");
  }
  void check() const;

  double torque(double speed, double voltage = 1) const { return stall_torque * (voltage - speed / synchronous_speed); }
  double no_load_speed() const { return synchronous_speed; }
  double rated_speed() const { return synchronous_speed; }
};

/// The droop that the curves of Xiong et al. (Minerals 2024, 14, 774, Fig. 10) follow: at the eccentric through
/// (160 rpm, 0) and (125 rpm, 21 kN m), that is 5729.6 N m s/rad (16.755 rad/s - w), 96 kN m at standstill; at the
/// motor shaft, through the gear of 3.75: 600 rpm and 25.6 kN m.
DroopMotor paper_droop();

}  // namespace gyro
