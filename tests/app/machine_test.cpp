// SPDX-License-Identifier: GPL-3.0-or-later
// The coupled run from inside: speeds and energies of the machine.
#include "app/device.hpp"
#include "app/simulation.hpp"
#include "tests/catch.hpp"

#include <cmath>

namespace {

using namespace gyro;

/// The small crusher in this process.
struct SmallCrusher {
  explicit SmallCrusher(const std::vector<std::string>& set)
      : input(load_case(GYRO_APP_CASES "/crush.yaml", set).loaded.value()),
        assembly(assemble(input)),
        simulation(input, assembly, make_dem(Device{}, assembly.scene, Loads::single)) {}

  Case input;
  Assembly assembly;
  Simulation simulation;
};

}  // namespace

TEST_CASE("A droop motor slows down while rock is crushed, and its energy account closes") {
  SmallCrusher run({"drivetrain.losses={no_load: 20 W, load_factor: 0.05}", "drivetrain.inertia.eccentric=0.01 kg m2"});
  const double idle = run.simulation.drivetrain()->state().speed;
  double slowest = idle, wall_work = 0;
  while (run.simulation.time() < 0.04) {
    wall_work += run.simulation.advance().load.work;
    slowest = std::min(slowest, run.simulation.drivetrain()->state().speed);
  }
  CHECK(slowest < 0.995 * idle);
  CHECK(slowest > 0.5 * idle);

  const Drivetrain& drive = *run.simulation.drivetrain();
  const DrivetrainState& s = drive.state();
  REQUIRE(wall_work > 0.1);
  CHECK(s.rock_work == Approx(wall_work));
  CHECK(run.simulation.ledger().energy().wall_work == Approx(wall_work).epsilon(1e-4));  // only the mantle moves
  CHECK(s.loss_work > 0.04 * 20 * 0.8);
  const double gain = drive.kinetic_energy() - s.start_energy;
  const double missing = s.motor_work - s.loss_work - s.rock_work - gain;
  CHECK(missing == Approx(drive.energy_residual()).margin(1e-9));
  CHECK(std::abs(missing) < 0.005 * s.rock_work);
}

TEST_CASE("The window's means add up to the machine's work") {
  SmallCrusher run({});
  const double idle_energy = run.simulation.drivetrain()->kinetic_energy();
  double motor = 0, crushing = 0, losses = 0;
  while (run.simulation.time() < 0.03) {
    const WindowResult window = run.simulation.advance();
    const DrivetrainMeans& m = run.simulation.drivetrain()->means();
    motor += m.motor_power * window.window.length();
    crushing += window.crushing_power * window.window.length();
    losses += m.loss_power * window.window.length();
  }
  const double gain = run.simulation.drivetrain()->kinetic_energy() - idle_energy;
  REQUIRE(crushing > 0.1);
  CHECK(losses == Approx(0).margin(1e-12));
  CHECK(motor == Approx(crushing + gain).margin(0.005 * crushing));
}

TEST_CASE("A motor of constant speed turns the eccentric at constant speed, whatever it crushes") {
  SmallCrusher run({"drivetrain.motor=null", "drivetrain.motor={model: constant_speed, speed: 1697 rpm}"});
  const double wanted = 1697.0 / 60 * 2 * 3.14159265358979323846 / 3.75;
  double work = 0;
  while (run.simulation.time() < 0.03) {
    work += run.simulation.advance().load.work;
    REQUIRE(run.simulation.drivetrain()->state().speed == Approx(wanted).epsilon(1e-12));
  }
  CHECK(work > 0.1);
  CHECK(run.simulation.drivetrain()->state().angle == Approx(wanted * run.simulation.time()).epsilon(1e-9));
}
