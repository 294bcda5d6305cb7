// SPDX-License-Identifier: GPL-3.0-or-later
// Run-up of NEMA motors without load, t = integral of J dw / T(w), against numbers from independent software:
// cages by scipy's fsolve from the name plates of double_cage.hpp, integrals by its adaptive quadrature (QUADPACK).
#include "app/verify/fixtures/drives.hpp"
#include "tests/catch.hpp"

namespace {

using namespace gyro;
using namespace gyro::fixtures;

struct RunUp {
  NemaDesign design;
  double share, time;  ///< of the synchronous speed [-]; of the run-up to it from rest [s]
};

constexpr double synchronous = 600 * rpm, at_motor = 5000 / (3.75 * 3.75) + 50;  // [rad/s], inertia [kg m2]

/// The same integral by Simpson's rule on this program's law.
double by_simpson(const DoubleCageMotor& motor, double speed) {
  constexpr int pieces = 4000;
  double sum = 0;
  for (int k = 0; k <= 2 * pieces; ++k)
    sum += (k == 0 || k == 2 * pieces ? 1 : k % 2 == 1 ? 4 : 2) / motor.torque(speed * k / (2 * pieces));
  return at_motor * sum * speed / (6 * pieces);
}

}  // namespace

TEST_CASE("NEMA motors run up in the time of the integral of J dw / T", "[mbd][motor]") {
  const RunUp c = GENERATE(RunUp{NemaDesign::a, 0.5, 1.103952126}, RunUp{NemaDesign::a, 0.9, 1.818924503},
                           RunUp{NemaDesign::a, 0.985, 1.953271832}, RunUp{NemaDesign::b, 0.5, 1.154686045},
                           RunUp{NemaDesign::b, 0.9, 2.057145500}, RunUp{NemaDesign::b, 0.985, 2.213166889},
                           RunUp{NemaDesign::c, 0.5, 0.783111194}, RunUp{NemaDesign::c, 0.9, 1.491461496},
                           RunUp{NemaDesign::c, 0.98, 1.648209228}, RunUp{NemaDesign::d, 0.5, 0.608534948},
                           RunUp{NemaDesign::d, 0.9, 1.231694521}, RunUp{NemaDesign::d, 0.935, 1.329199329});
  CAPTURE(static_cast<int>(c.design), c.share);
  const DoubleCageMotor motor = nema_motor(c.design, 450e3, synchronous);
  const double speed = c.share * synchronous;  // of the motor
  CHECK(by_simpson(motor, speed) == Approx(c.time).epsilon(1e-8));

  DrivetrainParameters machine = crusher_62_75(motor);
  machine.start = DrivetrainStart::rest;
  Drivetrain drive(machine);
  run(drive, c.time, 1000, no_rock);
  const double late = (speed - drive.motor_speed()) * at_motor / motor.torque(speed);
  CHECK(std::abs(late) < 1e-7);
}
