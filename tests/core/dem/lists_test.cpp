// SPDX-License-Identifier: GPL-3.0-or-later
// How often neighbour lists are made, and that they hold in corner cases; bits_test.cpp and H29 test that in all.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/dem/neighbour_lists.hpp"
#include "core/dem/wall_motion.hpp"
#include "core/exec/cpu.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// Rebuilds of the lists in 2000 steps of 2 us, of two spheres of 10 mm that touch nothing.
/// @param wall   speed of a plane and of a mesh [m/s]
/// @param speed  of one of the spheres [m/s]
std::int64_t rebuilds(double wall, double speed) {
  Scene scene = plain_scene(2e-6);
  scene.walls = {floor_plane(), floor_mesh(1)};
  for (Wall& w : scene.walls) w.motion = LinearMotion{{0, 0, wall}};
  const auto dem = make_cpu_dem(scene, Precision::mixed, 1);
  const std::vector<NewRock> spheres{sphere(0, {-0.2, 0, 0.5}, {speed, 0, 0}, 0.005, 2600),
                                     sphere(1, {0, 0.3, 0.5}, {0, 0, 0}, 0.005, 2600)};
  dem->insert(spheres);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 2000, 50);
  return dem->counts().rebuilds;
}

}  // namespace

TEST_CASE("Lists hold for tens of steps, whatever moves", "[dem]") {
  CHECK(rebuilds(0, 0) == 1);
  for (const double wall : {1e-3, 1.0, 100.0}) {
    INFO("walls at " << wall << " m/s");
    CHECK(rebuilds(wall, 0) > 2);
    CHECK(rebuilds(wall, 0) < 30);
  }
  for (const double speed : {10.0, 40.0}) {
    INFO("a sphere at " << speed << " m/s");
    CHECK(rebuilds(0, speed) > 2);
    CHECK(rebuilds(0, speed) < 80);
  }
}

TEST_CASE("A plane that rotates has no bound and is listed for as long as other walls, which are listed within one",
          "[dem]") {
  std::vector<Wall> walls{floor_plane(), floor_plane(), floor_mesh(1), floor_plane()};
  walls[0].motion = RotationMotion{{0, 1, 0}, {0, 0, 0}, 1e-3};
  walls[1].motion = LinearMotion{{0, 0, 1e9}};
  walls[2].motion = RotationMotion{{0, 0, 1}, {0, 0, 0}, 1e3};
  WallMotion<Cpu> motion(walls);
  motion.plan(walls, {0, 1, 1e-6}, {});
  REQUIRE(motion.steps().size() == 4);
  for (std::size_t w = 0; w < 4; ++w) CHECK(motion.steps()[w].bounded == (w > 0));

  Cpu cpu(1);
  NeighbourLists<Cpu, float> lists(0, false, false);
  ParticleStore<Cpu, float> rock(false);
  lists.rebuild(cpu, rock, {nullptr, nullptr, 0}, 1e-6, motion.steps());
  REQUIRE(lists.wall_ways().size() == 4);
  CHECK(lists.wall_ways()[0] > 100 * motion.steps()[0].way);  // for all particles, in a hundred steps
  for (std::size_t w = 1; w < 4; ++w) CHECK(lists.wall_ways()[w] == motion.steps()[w].way);  // no radius: a step
}

TEST_CASE("A rock with sub-steps meets walls in the same step, whatever the skin", "[dem]") {
  const bool starts_in_wall = GENERATE(true, false);  // or meets one that recedes
  const auto outcome = [&](double skin) {
    Scene scene = plain_scene(1e-5);
    scene.bonds = paper_bonds();
    scene.substeps = 8;
    scene.neighbour_skin = skin;
    Wall floor = floor_plane();
    if (!starts_in_wall) floor.motion = LinearMotion{{0, 0, -40}};
    scene.walls = {floor};
    const auto dem = make_cpu_dem(scene, Precision::double_, 1);
    const Vec3d v{0, 0, starts_in_wall ? 30.0 : -45.0};
    const double gap = starts_in_wall ? -1e-5 : 3e-4;
    const std::vector<NewRock> rocks{placed(bonded_pair(v, v), 0, 0, {0, 0, grain / 2 + gap})};
    dem->insert(rocks);
    std::int64_t step = 0;
    run(*dem, scene.dt, step, starts_in_wall ? 1 : 12, 1);
    return dem->particles().velocity[0].z;
  };
  const double far = outcome(0.5);
  CHECK(far > (starts_in_wall ? 30.0002 : -44.9999));
  for (const double skin : {0.0, 1e-8, 1e-7, 1e-5, 4e-4}) {
    CAPTURE(skin);
    CHECK(outcome(skin) == far);
  }
}
