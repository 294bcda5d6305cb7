// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Induction motors: quasi-static torque and current against the shaft's speed, from name plates.

namespace gyro {

/// Induction motor after Kloss (1916), from the figures of its name plate.
///
///   T(s) = 2 Tb s sb / (s^2 + sb^2),   s = 1 - speed / synchronous_speed
///   Tb = breakdown_ratio TN,  TN = rated_power / ((1 - sN) synchronous_speed)
///   sb = sN (lambda + sqrt(lambda^2 - 1)),  lambda = breakdown_ratio
///
/// so that T(sN) = TN. This form has no 0/0 at s = 0 and holds on every branch: s < 0 brakes
/// (generator), 0 < s < 1 drives, s > 1 is a shaft that turns backwards (plugging).
/// Limit: the stator's resistance is left out, so the starting torque 2 Tb / (sb + 1/sb) is lower
/// (0.4 TN for sN 1.67 %, lambda 2.5) than that of real crusher motors (about 2 TN, NEMA C): take
/// a DoubleCageMotor where the start under load matters.
struct InductionMotor {
  double rated_power = 0;        ///< mechanical, at the shaft [W]
  double synchronous_speed = 0;  ///< [rad/s]
  double rated_slip = 0;         ///< sN, 0 < sN < 1 [-]
  double breakdown_ratio = 0;    ///< largest torque / rated torque, > 1 [-]

  double rated_torque() const;      ///< TN [N m]
  double breakdown_torque() const;  ///< Tb [N m]
  double breakdown_slip() const;    ///< sb [-]
  double torque(double speed) const;
  /// Current / rated current: |s / (sb + j s)| over its value at rated slip. The magnetising current
  /// is left out, so it is 0 at synchronous speed where a real motor takes a third of its rated current.
  double current(double speed) const;
  /// Speed of zero torque [rad/s].
  double no_load_speed() const { return synchronous_speed; }
  /// Speed at which the losses are quoted [rad/s].
  double rated_speed() const { return (1 - rated_slip) * synchronous_speed; }
};

/// One cage of a rotor: Kloss's curve through its own breakdown.
struct Cage {
  double breakdown_torque = 0;  ///< [N m]
  double breakdown_slip = 0;    ///< [-]
};

/// Induction motor with two cages (or deep bars), which starts with more torque than Kloss's curve:
///
///   T(s) = T_inner(s) + T_outer(s),  each 2 Tk s sk / (s^2 + sk^2)
///   |I(s)| ~ |sum of Tk s / (sk + j s)|
///
/// The outer cage breaks down at standstill (sk = 1); the other three figures follow from the
/// name plate: T(sN) = TN, T(1) = starting_ratio TN, and breakdown_ratio TN is the first maximum met
/// when the motor slows down from rated speed. Stator resistance and coupling of the cages are left out.
struct DoubleCageMotor {
  double rated_power = 0;        ///< mechanical, at the shaft [W]
  double synchronous_speed = 0;  ///< [rad/s]
  double rated_slip = 0;         ///< sN, 0 < sN < 1 [-]
  double breakdown_ratio = 0;    ///< pull-out torque / rated torque, > 1 [-]
  double starting_ratio = 0;     ///< torque at standstill / rated torque, > 0 [-]
  Cage inner{}, outer{};         ///< found by solve_cages()

  double rated_torque() const { return rated_power / rated_speed(); }  ///< TN [N m]
  double torque(double speed) const;
  double current(double speed) const;  ///< / rated current, as InductionMotor's [-]
  double no_load_speed() const { return synchronous_speed; }
  double rated_speed() const { return (1 - rated_slip) * synchronous_speed; }
};

/// Finds the two cages of a name plate.
/// @throws BadInput when no pair of cages has these figures
DoubleCageMotor solve_cages(DoubleCageMotor name_plate);

/// Design letters of NEMA MG 1 for squirrel-cage motors.
enum class NemaDesign { a, b, c, d };

/// A typical motor of a design letter. Torques / rated torque and slip lie inside the bands that
/// the EASA handbook prints for the letter (locked rotor, breakdown, slip):
///   A  70-275 %, 175-300 %, 0.5-5 %:  1.5, 2.8, 1.5 %      B  as A, with less current:  1.5, 2.2, 1.5 %
///   C  200-250 %, 190-225 %, 1-5 %:   2.25, 2.1, 2 %       D  275 %, 275 %, 5-8 %:      2.75, 2.78, 6.5 %
/// C is the usual one for crushers that start under load. The bands are the source's, the choice in
/// them is ours: give a double_cage motor its own figures where they are known.
DoubleCageMotor nema_motor(NemaDesign design, double rated_power, double synchronous_speed);

}  // namespace gyro
