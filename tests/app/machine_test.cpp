// SPDX-License-Identifier: GPL-3.0-or-later
// The coupled run in this process: speeds and energies of the machine.
#include "tests/app/small_crusher.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;

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

TEST_CASE("A motor of constant speed turns the eccentric at constant speed under any load") {
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

TEST_CASE("With a spinning mantle and bearings the coupled energy account closes, too") {
  SmallCrusher run(
      {"drivetrain.mantle_inertia=0.01 kg m2",
       "drivetrain.bearings={bushing_depth: 675 mm, outer: {friction: 0.006, radius: 60 mm}, "
       "inner: {friction: 0.006, radius: 40 mm, idle_force: 40 N}, spider: {friction: 0.006, radius: 30 mm}}"});
  const Drivetrain& drive = *run.simulation.drivetrain();
  const double dragged = drive.state().spin;
  CHECK(dragged == Approx(drive.state().speed).epsilon(1e-4));  // idle: turns with the eccentric
  double minimum = dragged;
  while (run.simulation.time() < 0.04) {
    run.simulation.advance();
    minimum = std::min(minimum, drive.state().spin);
  }
  CHECK(minimum < 0.97 * dragged);  // the rock holds it back
  const DrivetrainState& s = drive.state();
  REQUIRE(std::abs(s.rock_work) > 0.1);
  CHECK(run.simulation.ledger().energy().wall_work == Approx(s.rock_work).epsilon(1e-4));
  CHECK(s.loss_work > 0);
  CHECK(std::abs(drive.energy_residual()) < 0.005 * std::abs(s.rock_work));
}

TEST_CASE("The energy account with rock closes to a thousandth, better in shorter windows") {
  const std::string interval = GENERATE("0.5 ms", "0.25 ms");
  SmallCrusher run({"coupling.interval=" + interval});
  double moved = 0;
  while (run.simulation.time() < 0.04) moved += std::abs(run.simulation.advance().load.work);
  const Drivetrain& drive = *run.simulation.drivetrain();
  CAPTURE(interval, moved, drive.energy_residual());
  CHECK(std::abs(drive.energy_residual()) < 1e-3 * (drive.state().motor_work + drive.state().start_energy));
  CHECK(std::abs(drive.energy_residual()) < 5e-3 * moved);
}

TEST_CASE("The impulses of particles add up to the loads of the walls, and recording them changes no result") {
  SmallCrusher noted({"output.liners={interval: 10 ms}"}), plain({});
  REQUIRE(noted.assembly.setup.scene.wall_impulses);
  REQUIRE_FALSE(plain.assembly.setup.scene.wall_impulses);
  std::vector<Vec3d> noted_sum(noted.assembly.setup.scene.walls.size()), load_sum(noted_sum.size());
  double slid = 0, size = 0;
  while (noted.simulation.time() < 0.02) {
    const WindowResult window = noted.simulation.advance();
    plain.simulation.advance();
    const std::vector<WallPose> poses = noted.simulation.dem().wall_poses();
    for (const WallImpulse& one : window.wall_impulses) {
      noted_sum[static_cast<std::size_t>(one.wall)] +=
          rotate(poses[static_cast<std::size_t>(one.wall)].orientation, one.impulse);
      slid += one.slip;
      CHECK(one.slip > -1e-6);  // the law's own error [J]
    }
    for (std::size_t w = 0; w < load_sum.size(); ++w) {
      load_sum[w] += window.window.length() * window.walls[w].force;
      size += window.window.length() * norm(window.walls[w].force);
    }
  }
  REQUIRE(size > 0);
  // Half of a step's load lies in the next window; the mantle turns a little between two rebuilds.
  for (std::size_t w = 0; w < load_sum.size(); ++w) CHECK(norm(noted_sum[w] - load_sum[w]) < 0.005 * size);
  CHECK(slid > 0);
  CHECK(slid < noted.simulation.ledger().energy().friction);
  const ParticleSnapshot a = noted.simulation.dem().particles(), b = plain.simulation.dem().particles();
  REQUIRE(a.size() == b.size());
  for (std::size_t k = 0; k < a.size(); ++k) REQUIRE(a.position[k].x == b.position[k].x);
}
