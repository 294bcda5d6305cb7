// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/drivetrain_parameters.hpp"

namespace gyro {

/// Load of the rock on the drive, constant over an interval.
struct ShaftLoad {
  double rock_torque = 0;    ///< T_c at the eccentric, positive when it resists forward motion [N m]
  double spin_torque = 0;    ///< T_s on the mantle about its own axis, positive about +u [N m]
  BearingForces bearings{};  ///< [N]
};

/// Speeds and loads at one moment.
struct ShaftPoint {
  double speed = 0;        ///< w, of the eccentric [rad/s]
  double spin = 0;         ///< sigma, of the mantle about its own axis [rad/s]
  double motor_speed = 0;  ///< [rad/s]
  double twist = 0;        ///< of the coupling spring: motor angle - i eccentric angle [rad]
  double voltage = 1;      ///< / rated voltage [-]
};

/// The signs of dry friction, which jumps where they change; constant during one leg of the integration.
struct FrictionSigns {
  int direction = 0;  ///< of the eccentric: +1 forward, 0 stuck, -1 backward
  int slip = 0;       ///< of sigma - w cos b: the mantle runs ahead (+1), is dragged along (0), lags (-1)
};

/// Torques and accelerations of one moment.
struct ShaftBalance {
  double acceleration = 0, spin_acceleration = 0, motor_acceleration = 0;  ///< [rad/s2]
  double motor_torque = 0, motor_power = 0, loss_power = 0;                ///< at the motor's shaft; [N m], [W]
  /// Torque that the inner bushing transmits to the mantle [N m]; while slip is 0, the torque that drags it along.
  double bushing_torque = 0;
  double stuck_forward = 0;   ///< net torque on a stuck eccentric if it were to start forward [N m]
  double stuck_backward = 0;  ///< likewise backward
};

/// The equations of motion of the drive, by virtual work, with angles theta (eccentric), psi (mantle
/// about its own axis u, sigma = psi'), and, with a coupling spring, the motor's own:
///
///   J theta''   = T_ecc - T_c - sign(w) T_dry - T_visc + s T_inner cos b - T_spider w sin^2 b / |Omega|
///   J_a sigma'  = T_s - s T_inner - T_spider sigma / |Omega|
///   s = sign(sigma - w cos b),  |Omega|^2 = w^2 sin^2 b + sigma^2,  Omega = w (z - cos b u) + sigma u
///
/// The inner bushing slides at sigma - w cos b: it drags the mantle towards the eccentric, and appears with cos b in
/// the eccentric's equation. The spider is a ball joint with a friction torque against Omega. While the mantle is
/// dragged along (s = 0) both equations are one, with the inertia J + J_a cos^2 b, and bushing_torque is the torque
/// that the bushing must transmit, at most T_inner. T_dry = T_0 + load_factor |T_c| + outer bushing + brake. Where no
/// mantle inertia is given, sigma is 0 and the bushing slides at w cos b.
class ShaftModel {
 public:
  /// @throws BadInput as check_drivetrain
  explicit ShaftModel(const DrivetrainParameters& parameters);

  /// @param sense         of the motor: +1 forward, -1 backward, 0 off
  /// @param brake_torque  dry, at the motor's shaft [N m]
  ShaftBalance balance(const ShaftPoint& now, FrictionSigns signs, double sense, double brake_torque) const;
  /// Torque at the motor's shaft [N m].
  double motor_torque_at(const ShaftPoint& now, double sense) const;
  double motor_current_at(const ShaftPoint& now, double sense) const;  ///< / rated current [-]

  /// Largest torque of the inner bushing under the present load [N m].
  double inner_torque() const { return inner_torque_; }
  void set_load(const ShaftLoad& load);

  bool ideal() const { return ideal_; }  ///< constant speed; the motor's torque follows from the load
  bool mantle_spins() const { return mantle_inertia_ > 0; }
  bool has_spring() const { return spring_.stiffness > 0; }
  double gear_ratio() const { return transmission_.ratio; }
  double cos_tilt() const { return cos_tilt_; }
  double inertia() const { return inertia_; }                ///< of all that turns rigidly with the eccentric [kg m2]
  double motor_inertia() const { return motor_inertia_; }    ///< about the motor's shaft [kg m2]
  double mantle_inertia() const { return mantle_inertia_; }  ///< about the mantle's axis [kg m2]
  double spring_stiffness() const { return spring_.stiffness; }  ///< at the motor's shaft [N m/rad]

 private:
  struct Spider {
    double on_eccentric = 0, on_mantle = 0, power = 0;
  };
  Spider spider(const ShaftPoint& now, FrictionSigns signs, double free_mantle_torque) const;
  double input_torque(const ShaftPoint& now, double at_motor) const;
  void move_both(ShaftBalance& b, const Spider& held, double net) const;
  void drive_ideally(ShaftBalance& b, const ShaftPoint& now, const Spider& held, double dry) const;
  double losses_at(const ShaftPoint& now, const ShaftBalance& b, FrictionSigns signs, double input, double dry) const;

  Motor motor_;
  bool ideal_;
  double rated_motor_torque_;
  Transmission transmission_;
  Losses losses_;
  Bearings bearings_;
  CouplingSpring spring_;
  double inertia_, motor_inertia_, mantle_inertia_, cos_tilt_;
  ShaftLoad load_;
  double inner_torque_ = 0, spider_torque_ = 0, dry_torque_ = 0;
};

}  // namespace gyro
