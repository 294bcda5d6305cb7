// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mbd/motors/cage.hpp"

namespace gyro {

/// Induction motor with two cages (or deep bars), which starts with more torque than Kloss's curve:
///
///   T(s) = T_inner(s) + T_outer(s),  each 2 Tk s sk / (s^2 + sk^2)
///   |I(s)| ~ |sum of Tk s / (sk + j s)|
///
/// The outer cage breaks down at standstill (sk = 1). The other three figures follow from the name plate:
/// T(sN) = TN, T(1) = starting_ratio TN, and breakdown_ratio TN is the first maximum that is met when the motor slows
/// down from rated speed. The torque is proportional to the voltage squared. Stator resistance and coupling of the
/// cages are left out.
struct DoubleCageMotor {
  static constexpr const char* model = "double_cage";

  double rated_power = 0;        ///< mechanical, at the shaft [W]
  double synchronous_speed = 0;  ///< [rad/s]
  double rated_slip = 0;         ///< sN, 0 < sN < 1 [-]
  double breakdown_ratio = 0;    ///< pull-out torque / rated torque, > 1 [-]
  double starting_ratio = 0;     ///< torque at standstill / rated torque, > 0 [-]
  Cage inner{}, outer{};         ///< computed by complete()

  template <class F, class Self>
  static void for_each_parameter(F&& f, Self& m) {
    f("rated_power", "W", m.rated_power, "mechanical power at rated slip");
    f("synchronous_speed", "rad/s", m.synchronous_speed, "speed of zero torque");
    f("rated_slip", "", m.rated_slip, "1 - rated speed / synchronous speed");
    f("breakdown_ratio", "", m.breakdown_ratio, "pull-out torque / rated torque");
    f("starting_ratio", "", m.starting_ratio, "torque at standstill / rated torque");
  }
  void check() const;
  /// Computes the cages from the name plate. @throws BadInput as solve_cages
  void complete();

  double torque(double speed, double voltage = 1) const;
  double current(double speed) const;  ///< / rated current, as InductionMotor's [-]
  double no_load_speed() const { return synchronous_speed; }
  double rated_speed() const { return (1 - rated_slip) * synchronous_speed; }
  double rated_torque() const { return rated_power / rated_speed(); }  ///< TN [N m]
};

/// The motor of a name plate with its two cages.
/// @throws BadInput when no pair of cages has these figures
DoubleCageMotor solve_cages(DoubleCageMotor name_plate);

/// Design letters of NEMA MG 1 for squirrel-cage motors.
enum class NemaDesign { a, b, c, d };

/// A typical motor of a design letter. Torques / rated torque and slip lie inside the bands that the EASA handbook
/// prints for the letter (locked rotor, breakdown, slip):
///   A  70-275 %, 175-300 %, 0.5-5 %:  1.5, 2.8, 1.5 %      B  as A, with less current:  1.5, 2.2, 1.5 %
///   C  200-250 %, 190-225 %, 1-5 %:   2.25, 2.1, 2 %       D  275 %, 275 %, 5-8 %:      2.75, 2.78, 6.5 %
/// C is usual for crushers that start under load. The bands are from the handbook; the values inside them are our
/// choice. If the figures of a motor are known, use a double_cage motor with them.
DoubleCageMotor nema_motor(NemaDesign design, double rated_power, double synchronous_speed);

}  // namespace gyro
