// SPDX-License-Identifier: GPL-3.0-or-later
// How often neighbour lists are made. That they hold is tested by bits_test.cpp and H29.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
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

TEST_CASE("Lists hold for some hundred steps, whatever moves", "[dem]") {
  CHECK(rebuilds(0, 0) == 1);
  for (const double wall : {1e-3, 1.0, 100.0}) {
    INFO("walls at " << wall << " m/s");
    CHECK(rebuilds(wall, 0) > 2);
    CHECK(rebuilds(wall, 0) < 15);
  }
  for (const double speed : {10.0, 40.0}) {
    INFO("a sphere at " << speed << " m/s");
    CHECK(rebuilds(0, speed) > 2);
    CHECK(rebuilds(0, speed) < 25);
  }
}
