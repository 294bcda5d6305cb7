// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/shaft.hpp"

#include "core/base/errors.hpp"
#include "tests/catch.hpp"
#include "tests/mbd/machines.hpp"

#include <array>
#include <limits>

namespace gyro {
namespace {

/// Time at which a Kloss motor without load reaches a slip, from rest [s]:
///   t(s) = (J w0 / 2 Tb) [(1 - s^2) / (2 sb) + sb ln(1/s)]
double run_up_time(double slip) {
  const double inertia = 500, synchronous = 100, torque = 1000, breakdown = 0.1;
  return inertia * synchronous / (2 * torque) * ((1 - slip * slip) / (2 * breakdown) + breakdown * std::log(1 / slip));
}

DrivetrainParameters kloss_machine() {
  return {.motor = textbook_kloss(), .eccentric_inertia = 500, .start = DrivetrainStart::rest};
}

}  // namespace

TEST_CASE("CVODE finds the times of the Kloss run-up", "[mbd][shaft]") {
  const auto [slip, printed] =
      GENERATE(table<double, double>({{0.5, 95.482868}, {0.1, 129.506463}, {0.05, 132.176831}}));
  CAPTURE(slip);
  CHECK(run_up_time(slip) == Approx(printed).margin(1e-6));

  const InductionMotor motor = textbook_kloss();
  const std::array<double, 1> tolerance{1e-10};
  CvodeSession session(
      {.size = 1, .absolute_tolerance = tolerance},
      [&](std::span<const double> y, std::span<double> rate) { rate[0] = motor.torque(y[0]) / 500; },
      [slip = slip](std::span<const double> y) { return y[0] - 100 * (1 - slip); });
  std::array<double, 1> speed{0};
  const double reached = session.integrate(200, speed);
  CHECK(std::abs(reached - run_up_time(slip)) < 1e-6);
  CHECK(speed[0] == Approx(100 * (1 - slip)).epsilon(1e-12));
}

TEST_CASE("Kloss run-up in windows reaches each slip at its time", "[mbd][shaft]") {
  const double slip = GENERATE(0.5, 0.1, 0.05);
  const int windows = GENERATE(1, 50, 2000);
  CAPTURE(slip, windows);
  Drivetrain drivetrain(kloss_machine());
  run(drivetrain, run_up_time(slip), windows, no_rock);
  const double acceleration = textbook_kloss().torque(100 * (1 - slip)) / 500;
  const double late = (100 * (1 - slip) - drivetrain.state().speed) / acceleration;  // [s]
  CHECK(std::abs(late) < 1e-6);
}

TEST_CASE("Gear reflects the motor's inertia with the square of its ratio", "[mbd][shaft]") {
  const double ratio = GENERATE(1.0, 3.75, 5.0);
  CAPTURE(ratio);
  DrivetrainParameters machine{.motor = DroopMotor{.synchronous_speed = 60, .stall_torque = 2000},
                               .gear_ratio = ratio,
                               .motor_inertia = 50,
                               .eccentric_inertia = 700,
                               .start = DrivetrainStart::rest};
  CHECK(machine.effective_inertia() == Approx(700 + 50 * ratio * ratio).epsilon(1e-15));
  // Droop without load: w = ws (1 - exp(-t / tau)), tau = J_eff ws / (i T_stall), at the eccentric.
  const double idle = 60 / ratio;
  const double tau = (700 + 50 * ratio * ratio) * idle / (ratio * 2000);
  Drivetrain drivetrain(machine);
  run(drivetrain, tau, 100, no_rock);
  CHECK(drivetrain.state().speed == Approx(idle * (1 - std::exp(-1.0))).epsilon(1e-9));
  CHECK(drivetrain.state().angle == Approx(idle * tau * std::exp(-1.0)).epsilon(1e-9));
  CHECK(drivetrain.motor_speed() == ratio * drivetrain.state().speed);
  // Rigid and without losses: power in is power out.
  CHECK(drivetrain.state().motor_work == Approx(drivetrain.kinetic_energy()).epsilon(1e-9));
}

TEST_CASE("Gear losses take the same share whichever way power flows", "[mbd][shaft]") {
  const Transmission gear{.ratio = 3.75, .efficiency = 0.96};
  CHECK(gear.torque_at_eccentric(1000, +1) == Approx(3600));
  CHECK(gear.torque_at_eccentric(-1000, +1) == Approx(-3750 / 0.96));
  CHECK(gear.torque_at_eccentric(1000, -1) == Approx(3750 / 0.96));
  for (const double torque : {-500.0, 0.0, 500.0})
    for (const int direction : {-1, +1})
      CHECK(gear.torque_at_motor(gear.torque_at_eccentric(torque, direction), direction) == Approx(torque));
}

TEST_CASE("Viscous and dry losses: speed approaches the balance exponentially", "[mbd][shaft]") {
  // J dw/dt = T (1 - w/ws) - T0 - f Tr - Tr - c w: a line in w.
  DrivetrainParameters machine{.motor = DroopMotor{.synchronous_speed = 20, .stall_torque = 50e3},
                               .eccentric_inertia = 4000,
                               .losses = {.no_load_power = 60e3, .load_factor = 0.05, .viscous = 100}};
  const double slope = 50e3 / 20 + 100;
  const double rock = 12e3, dry = 60e3 / 20, end = 0.7;
  const double idle = (50e3 - dry) / slope, loaded = (50e3 - dry - 1.05 * rock) / slope;
  CHECK(idle_speed(machine) == Approx(idle).epsilon(1e-14));
  Drivetrain drivetrain(machine);
  run(drivetrain, end, 350, [&](double, double) { return rock; });
  CHECK(drivetrain.state().speed == Approx(loaded + (idle - loaded) * std::exp(-slope / 4000 * end)).epsilon(1e-9));
}

TEST_CASE("Energy of the equation alone balances", "[mbd][shaft]") {
  const Motor motor = GENERATE(Motor{induction_450kw()}, Motor{paper_droop()});
  DrivetrainParameters machine = crusher_62_75(motor);
  machine.gear_efficiency = 0.96;
  machine.losses = {.no_load_power = 60e3, .load_factor = 0.05, .viscous = 20};
  Shaft shaft(machine);
  ShaftMotion motion{.speed = idle_speed(machine), .direction = +1};
  const double length = GENERATE(0.5e-3, 50e-3);
  double motor_work = 0, spent = 0;
  for (int k = 0; k < 1000; ++k) {
    const double rock = 21e3 * (1 + std::sin(0.13 * k));
    const ShaftTurn turn = shaft.turn(length, rock, motion);
    motor_work += turn.motor_work;
    spent += rock * turn.angle + turn.loss_work + turn.kinetic_gain;
  }
  CAPTURE(length, motor_work, spent);
  CHECK(motor_work > 1e4);
  CHECK(std::abs(motor_work / spent - 1) < 1e-6);
}

TEST_CASE("A restart per window costs tens of evaluations, long or short", "[mbd][shaft]") {
  const InductionMotor motor = induction_450kw();
  const double length = GENERATE(1e-6, 0.5e-3, 50e-3);
  const std::array<double, 1> tolerance{1e-12};
  CvodeSession session({.size = 1, .absolute_tolerance = tolerance},
                       [&](std::span<const double> y, std::span<double> rate) {
                         rate[0] = (3.75 * motor.torque(3.75 * (16.5 + y[0])) - 21e3) / 5703;
                       },
                       {});
  std::array<double, 1> gain{0};
  session.integrate(length, gain);
  CAPTURE(length, session.rate_evaluations());
  CHECK(session.rate_evaluations() < 200);
}

TEST_CASE("Not-finite values and errors inside the equation stop the run", "[mbd][shaft]") {
  const std::array<double, 1> tolerance{1e-10};
  CvodeSession session({.size = 1, .absolute_tolerance = tolerance},
                       [](std::span<const double> y, std::span<double> rate) {
                         if (y[0] > 0.5) throw BadInput("beyond the table; accepted are values up to 0.5");
                         rate[0] = 1;
                       },
                       {});
  std::array<double, 1> y{std::numeric_limits<double>::quiet_NaN()};
  CHECK_THROWS_AS(session.integrate(1, y), StoppedByGuard);
  y[0] = 0;
  CHECK_THROWS_AS(session.integrate(1, y), BadInput);
  y[0] = 0;
  CHECK(session.integrate(0.25, y) == 0.25);  // and it can be used again
  CHECK(y[0] == Approx(0.25).epsilon(1e-12));
}

}  // namespace gyro
