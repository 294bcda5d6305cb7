// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/shaft.hpp"
#include "app/verify/fixtures/drives.hpp"

#include "core/base/errors.hpp"
#include "tests/catch.hpp"

#include <array>
#include <limits>

namespace gyro {
namespace {

using namespace fixtures;

/// The formula of KlossTime [s].
double run_up_time(double slip) {
  const double inertia = 500, synchronous = 100, torque = 1000, breakdown = 0.1;
  return inertia * synchronous / (2 * torque) * ((1 - slip * slip) / (2 * breakdown) + breakdown * std::log(1 / slip));
}

}  // namespace

TEST_CASE("CVODE finds the times of the Kloss run-up", "[mbd][shaft]") {
  const auto [slip, printed] = GENERATE(from_range(std::begin(kloss_times), std::end(kloss_times)));
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

TEST_CASE("Gear losses are the same share of the power in both directions of flow", "[mbd][shaft]") {
  const Transmission gear{.ratio = 3.75, .efficiency = 0.96};
  CHECK(gear.torque_at_eccentric(1000, +1) == Approx(3600));
  CHECK(gear.torque_at_eccentric(-1000, +1) == Approx(-3750 / 0.96));
  CHECK(gear.torque_at_eccentric(1000, -1) == Approx(3750 / 0.96));
  for (const double torque : {-500.0, 0.0, 500.0})
    for (const int direction : {-1, +1})
      CHECK(gear.torque_at_motor(gear.torque_at_eccentric(torque, direction), direction) == Approx(torque));
}

TEST_CASE("A restart of the solver costs tens of evaluations, in long and in short windows", "[mbd][shaft]") {
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

TEST_CASE("Values that are not finite and errors inside the equation stop the run", "[mbd][shaft]") {
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
