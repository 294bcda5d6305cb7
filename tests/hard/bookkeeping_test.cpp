// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of bookkeeping: threads, balances, numbers that are not finite during a run.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/base/errors.hpp"
#include "tests/app/program.hpp"
#include "tests/app/small_crusher.hpp"
#include "tests/catch.hpp"

#include <limits>

using namespace gyro;
using namespace gyro::fixtures;

TEST_CASE("H30 a number that is not finite stops the run at the end of its window, with the id", "[hard]") {
  const double bad = GENERATE(std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity());
  SmallCrusher run({});
  for (int k = 0; k < 10; ++k) {
    run.simulation.advance();
    REQUIRE_FALSE(run.simulation.verdict());
  }
  const std::vector<NewRock> bad_sphere{sphere(777777, {0.125, 0, 0.1}, {0, 0, bad}, 0.002, 2600)};
  run.dem.insert(bad_sphere);
  run.simulation.advance();
  REQUIRE(run.simulation.verdict());
  CHECK(run.simulation.verdict()->find("particle 777777") != std::string::npos);
  CHECK_THROWS_AS(run.simulation.require_sound(), StoppedByGuard);
}

TEST_CASE("H32 sixty-four threads give the same bits as one", "[hard]") {
  Scene scene = plain_scene(2e-6);
  scene.pairs.assign(4, {0.5, 0.25, 0.02});
  scene.bonds = paper_bonds();
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 2e5;
  scene.walls = box({0.2, 0.2, 0.2});
  NewRock cube = lattice(0, 3);
  scatter_strength(cube);
  std::vector<NewRock> rocks;
  for (int k = 0; k < 27; ++k)
    rocks.push_back(placed(cube, k, static_cast<ParticleId>(100 * k),
                           0.11 * Vec3d{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0}, rotation_about({0, 0.6, 0.8}, k)));
  for (NewRock& r : rocks)
    for (NewParticle& p : r.particles) p.velocity = -60.0 * p.position;
  const auto one = make_cpu_dem(scene, Precision::mixed, 1);
  one->insert(rocks);
  std::int64_t step = 0;
  run(*one, scene.dt, step, 200);
  REQUIRE(one->counts().broken_tension + one->counts().broken_shear > 20);
  for (const int threads : {13, 64}) {
    const auto many = make_cpu_dem(scene, Precision::mixed, threads);
    many->insert(rocks);
    std::int64_t other = 0;
    run(*many, scene.dt, other, 200);
    CHECK(same_bits(one->particles(), many->particles()));
    CHECK(one->energy().residual() == many->energy().residual());
  }
}

TEST_CASE("H33 every particle that was fed is inside or discharged", "[hard]") {
  // Small rocks fall through the open gap while more are fed.
  const std::string rigid = GENERATE("off", "pieces");
  SmallCrusher run({"feed={rate: 60 t/h, above: concave}", "crusher.closed_side_setting=40 mm", "rocks.fill.ratio=2",
                    "drivetrain.motor.stall_torque=600 N m", "numerics.levels.rigid=" + rigid});
  while (run.simulation.time() < 0.45) {
    run.simulation.advance();
    REQUIRE_FALSE(run.simulation.verdict());
    run.simulation.inspect();
    const MassCount count = run.simulation.mass_count();
    REQUIRE(count.residual() == 0);
  }
  const MassCount count = run.simulation.mass_count();
  INFO(count.fed << " fed, " << count.discharged << " discharged, " << count.inside << " inside");
  CHECK(count.discharged > 50);
  CHECK(count.inside > 0);
  CHECK(count.fed == run.simulation.fed().particles);
}

TEST_CASE("H36 the program's clock is the count of steps", "[hard]") {
  SmallCrusher run({});
  for (int k = 0; k < 5; ++k) run.simulation.advance();
  CHECK(run.simulation.time() == 5.0 * run.assembly.step.steps_per_window * run.assembly.setup.scene.dt);
}
