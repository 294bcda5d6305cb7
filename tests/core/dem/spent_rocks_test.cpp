// SPDX-License-Identifier: GPL-3.0-or-later
// A rock whose bonds are all broken gives up its sub-steps.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"
#include "tests/gpu/mirror.hpp"
#include "tests/gpu/same_bits.hpp"

#include "core/state/bonds.hpp"

#include <array>
#include <cmath>

using namespace gyro;
using namespace gyro::fixtures;
using namespace gyro::test;

namespace {

constexpr int substeps = 4, window = 10;
constexpr double radius = grain / 2;

/// An elastic floor without friction.
Scene on_floor() {
  Scene scene = bonded_scene(2e-6, paper_bonds());
  scene.pairs.assign(4, {0, 1, 0});
  scene.gravity = {0, 0, -9.81};
  scene.walls = {floor_plane()};
  scene.substeps = substeps;
  return scene;
}

/// Two spheres that are pressed into the floor and fly apart.
NewRock parting(double speed) {
  NewRock rock = placed(bonded_pair({-speed, 0, 0}, {speed, 0, 0}), 0, 0, {0, 0, 0.999 * radius});
  return rock;
}

/// Rocks of two kinds of sub-steps that break wholly, or nearly so.
Scene breaking_wholly() {
  Scene scene = breaking_scene();
  scene.bonds->tensile_strength *= 0.05;
  scene.bonds->shear_strength *= 0.05;
  scene.substeps = 3;
  return scene;
}

/// What a scene saves after some windows, before each of which it is moved into another solver.
SavedState moved_on(const std::vector<std::unique_ptr<Dem>>& solvers) {
  SavedState state;
  std::int64_t step = 0;
  for (std::size_t w = 0; w < 30; ++w) {
    Dem& dem = *solvers[w % solvers.size()];
    if (w > 0) dem.restore(state);
    if (w == 0) dem.insert(falling_rocks(0, 0, 0.045));
    run(dem, breaking_dt, step, 150, 150);
    state = dem.save();
  }
  return state;
}

std::vector<std::unique_ptr<Dem>> on_threads(std::vector<int> threads) {
  std::vector<std::unique_ptr<Dem>> solvers;
  for (const int n : threads) solvers.push_back(make_cpu_dem(breaking_wholly(), Precision::mixed, n));
  return solvers;
}

double step_of(const SavedState& s, std::size_t particle) {
  return s.get<double>("particles/step")[particle];
}

}  // namespace

TEST_CASE("Only a rock without any bond gives up its sub-steps, and at the begin of a window", "[dem][hold]") {
  const Scene scene = on_floor();
  Stage stage(scene, Precision::mixed);
  NewRock whole = placed(chain(1, 3), 1, 2, {0, 1, 1});
  NewRock cracked = placed(chain(2, 3), 2, 6, {0, 2, 1});
  cracked.particles[0].velocity = {-20, 0, 0};
  stage.insert({parting(20), whole, cracked});
  stage.advance(200);  // in a window the rock keeps what it has
  REQUIRE(stage.dem().counts().bonds_intact == 5);
  CHECK(step_of(stage.dem().save(), 0) == scene.dt / substeps);
  stage.advance(window);
  const SavedState s = stage.dem().save();
  CHECK(step_of(s, 0) == scene.dt);
  CHECK(step_of(s, 1) == scene.dt);
  for (std::size_t n = 2; n < 10; ++n) CHECK(step_of(s, n) == scene.dt / substeps);
  const auto blocks = s.get<Block>("blocks");
  CHECK(blocks[0].substeps == 1);
  CHECK(blocks[0].first_bond == blocks[0].end_bond);
  for (std::size_t k = 1; k < 3; ++k) {
    CHECK(blocks[k].substeps == substeps);
    CHECK(blocks[k].end_bond > blocks[k].first_bond);
  }
}

TEST_CASE("Pressed ends of a failed bond keep the sub-steps of their rock", "[dem][hold]") {
  Scene scene = on_floor();
  scene.bonds->shear_strength = 1e5;
  Stage stage(scene, Precision::mixed);
  NewRock rock = placed(bonded_pair({0.5, 0, 0}, {-0.5, 0, 0}), 0, 0, {0, 0, 1});
  rock.particles[0].velocity.y = 0.2;
  stage.insert({rock});
  int pressed = 0;
  for (int w = 0; w < 40; ++w) {
    const std::int32_t state = stage.dem().save().get<std::int32_t>("bonds/state")[0];  // when the window begins
    stage.advance(1);
    CHECK(step_of(stage.dem().save(), 0) == scene.dt / (state == bond_broken ? 1 : substeps));
    pressed += state == bond_pressed;
  }
  CHECK(pressed > 1);
}

TEST_CASE("Momentum and energy close where a rock on a floor gives up its sub-steps", "[dem][hold][ledger]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const Scene scene = on_floor();
  Stage stage(scene, precision);
  stage.insert({parting(20)});
  const double mass = 2 * rock_density * 4 / 3 * M_PI * std::pow(radius, 3), time = window * scene.dt;
  int changes = 0;
  double elastic = 0, before_change = 0;
  for (int w = 0; w < 40; ++w) {
    const double momentum = stage.dem().momentum().z, step = step_of(stage.dem().save(), 0);
    const EnergyTerms energy = stage.dem().energy();
    stage.advance(window);
    const double floor = stage.dem().wall_loads()[0].force.z;
    if (step_of(stage.dem().save(), 0) != step) {
      ++changes;
      elastic = energy.contact_elastic;
      before_change = energy.residual();
      REQUIRE(floor < -1);
    }
    INFO("window " << w << ", " << floor << " N");
    CHECK(std::abs(stage.dem().momentum().z - momentum + time * (floor + mass * 9.81)) < 1e-11);  // 2^-44 an addition
  }
  REQUIRE(changes == 1);
  REQUIRE(elastic > 0);
  INFO("elastic energy " << elastic << " J");
  CHECK(std::abs(stage.dem().energy().residual() - before_change) < 0.01 * elastic);
}

TEST_CASE("Rocks give up their sub-steps with the same bits after a restart, on threads and on a device",
          "[dem][hold][bits]") {
  const SavedState one = moved_on(on_threads({1}));
  REQUIRE(one.get<Block>("blocks")[0].substeps == 1);
  const double dt = breaking_dt;
  REQUIRE(step_of(one, 0) == dt);
  DeviceMemory::instance().forget();
  std::vector<std::unique_ptr<Dem>> mirror;
  mirror.push_back(std::make_unique<DemSolver<Mirror, float>>(breaking_wholly(), Mirror{}));
  for (const SavedState& other : {moved_on(on_threads({2, 1, 7})), moved_on(mirror)}) {
    CHECK(same_bytes(one.get<Block>("blocks"), other.get<Block>("blocks")));
    CHECK(same_bytes(one.get<double>("particles/step"), other.get<double>("particles/step")));
    for (const char* name : {"particles/position/centre", "particles/motion/velocity", "particles/load/force"})
      CHECK(same_bytes(one.get<Vec3d>(name), other.get<Vec3d>(name)));
  }
}
