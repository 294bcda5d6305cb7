// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of walls: passing through, thin plates, needle triangles, walls that move too fast.
#include "app/simulation/ledger.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/meshes.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// A scene that runs until the guard stops it, and its verdict.
struct Watched {
  std::optional<std::string> verdict;
  double time = 0;
  ParticleSnapshot last;
};
Watched watched(const Scene& scene, const std::vector<NewRock>& rocks, Precision precision, int windows, int steps) {
  const auto dem = make_cpu_dem(scene, precision, 1);
  dem->insert(rocks);
  Ledger ledger({.step = scene.limits}, {"wall"});
  Watched w;
  for (int k = 0; k < windows && !w.verdict; ++k) {
    ledger.open(dem->energy());
    dem->advance({std::int64_t{k} * steps, steps, scene.dt}, {});
    w.time = (k + 1) * steps * scene.dt;
    w.verdict = ledger.close(w.time, dem->energy(), dem->extremes());
  }
  w.last = dem->particles();
  return w;
}

}  // namespace

TEST_CASE("H6 a sphere too fast for the step is stopped before it passes a thin wall", "[hard]") {
  // 8 mm sphere at 200 m/s. With steps v dt < 0.2 R it rebounds; with longer ones the run stops.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double way = GENERATE(0.02, 0.15, 0.21, 0.5, 1.0, 3.0), offset = GENERATE(0.0, 0.37, 0.61);
  const double radius = 0.004, speed = 200;
  Scene scene = plain_scene(way * radius / speed);
  scene.materials[0] = elastic(1.4e9, 0.3, 2600);  // 0.6 R of overlap at this speed
  scene.walls = {{"wall", tiled_square(0.1, 8), Fixed{}, 1}};
  const std::vector<NewRock> one{sphere(0, {0.013, 0.021, radius * (3 + way * offset)}, {0, 0, -speed}, radius, 2600)};
  const int steps = static_cast<int>(std::ceil(10 / way));
  const Watched w = watched(scene, one, precision, 1, steps);  // one window; the guard must detect the peaks inside it
  INFO("v dt " << way << " R: " << w.verdict.value_or("no verdict"));
  if (way > 0.2) {
    REQUIRE(w.verdict);
    CHECK(w.verdict->find("particle 0 moves by") != std::string::npos);
  } else {
    CHECK_FALSE(w.verdict);
    CHECK(w.last.position[0].z > radius);
    CHECK(w.last.velocity[0].z == Approx(speed).epsilon(way < 0.1 ? 2e-3 : 0.05));
  }
}

TEST_CASE("H6 a sphere pressed through a thin wall is stopped before its normal flips", "[hard]") {
  // Pressed by 1e5 N, as by the bed above it: with a soft contact the centre passes the wall.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double shear_modulus = GENERATE(20e6, 557e6, 20e9);
  const double radius = 0.004;
  Scene scene = plain_scene(1e-7);
  scene.materials[0].shear_modulus = shear_modulus;
  scene.pairs.assign(4, {0.5, 0.2, 0});
  const double mass = sphere_mass(radius, 2600);
  scene.gravity = {0, 0, -1e5 / mass};
  scene.walls = {{"wall", tiled_square(0.1, 8), Fixed{}, 1}};
  const std::vector<NewRock> one{sphere(7, {0.013, 0.021, radius}, {0, 0, 0}, radius, 2600)};
  const Watched w = watched(scene, one, precision, 40, 100);
  INFO(shear_modulus << ": " << w.verdict.value_or("no verdict") << ", z " << w.last.position[0].z / radius << " R");
  if (shear_modulus < 1e10) {
    REQUIRE(w.verdict);
    CHECK(w.verdict->find("particle 7") != std::string::npos);
  } else {
    CHECK_FALSE(w.verdict);
    CHECK(w.last.position[0].z > 0.2 * radius);
    CHECK(w.last.position[0].z < radius);
  }
}

TEST_CASE("H6 a one-sided liner keeps its normal when a centre is pressed through", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double depth = GENERATE(0.5, 0.99, 1.01, 1.5, 1.9);  // of the surface beyond the nearest point of the sphere
  const double radius = 0.01;
  Scene scene = plain_scene(1e-8);
  const bool profile = GENERATE(true, false);
  scene.walls = {{"tube", ProfileShape{{{0.1, -1}, {0.1, 1}}}, Fixed{}, 1}};
  if (!profile) scene.walls[0].shape = PlaneShape{{0.1, 0, 0}, {-1, 0, 0}};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> one{sphere(0, {0.1 + (depth - 1) * radius, 0, 0}, {0, 0, 0}, radius, 2600)};
  dem->insert(one);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 1);
  CHECK(dem->particles().force[0].x < 0);
  CHECK(dem->extremes().overlap_ratio == Approx(depth).epsilon(1e-6));
  CHECK(dem->extremes().wall == 0);
}

TEST_CASE("H6 a wall or liner that moves too fast for the step is stopped", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double way = GENERATE(0.09, 0.25, 5.0), radius = 0.004;
  const int kind = GENERATE(0, 1, 2, 3);
  Scene scene = plain_scene(1e-6);
  scene.materials[0] = elastic(2e12, 0.3, 2600);
  const double speed = way * radius / scene.dt;
  Wall wall{"wall", tiled_square(0.1, 8, -0.02), LinearMotion{{0, 0, speed}}, 1};
  if (kind == 1) {  // a paddle whose outer edge is the fastest
    wall.shape = TriangleMesh{{{0, 0, -1}, {0.2, 0, -1}, {0.2, 0, 1}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}}};
    wall.motion = RotationMotion{{0, 0, 1}, {0, 0, 0}, speed / std::sqrt(0.04 + 1)};  // at the farthest corner
  }
  if (kind == 2) {
    wall.shape = ProfileShape{{{0.1, -1}, {0.1, 1}}};
    wall.motion = LinearMotion{{speed, 0, 0}};
  }
  if (kind == 3) wall = {"press", PlaneShape{{0, 0, -0.02}, {0, 0, 1}}, LinearMotion{{0, 0, speed}}, 1};
  scene.walls = {wall};
  // The sphere is beside the walls and is not hit, except by the plane, which is infinite.
  const std::vector<NewRock> one{sphere(0, {0.5, 0.02, 0}, {0, 0, 0}, radius, 2600)};
  const Watched w = watched(scene, one, precision, 1, static_cast<int>(std::ceil(10 / way)));
  INFO("wall way " << way << " R, kind " << kind << ": " << w.verdict.value_or("no verdict"));
  if (way < 0.2) {
    CHECK_FALSE(w.verdict);
  } else {
    REQUIRE(w.verdict);
    if (kind < 3) CHECK(w.verdict->find("wall wall moves by") != std::string::npos);
    if (kind == 3) CHECK(w.verdict->find("particle 0") != std::string::npos);
  }
}

TEST_CASE("H6 a liner that spins about its own axis may spin fast", "[hard]") {
  Scene scene = plain_scene(1e-6);
  scene.walls = {{"tube", ProfileShape{{{0.1, -1}, {0.1, 1}}}, RotationMotion{{0, 0, 1}, {0, 0, 0}, 1e5}, 1}};
  const std::vector<NewRock> one{sphere(0, {0.01, 0.02, 0}, {0, 0, 0}, 0.004, 2600)};
  CHECK_FALSE(watched(scene, one, Precision::double_, 1, 10).verdict);
}

TEST_CASE("H7 beds on both sides of a thin plate do not interact", "[hard]") {
  // Plates of 1 mm and 0.1 mm of two layers of triangles, and a single layer; spheres of 19 mm are thrown at them from
  // above and below. They overlap by up to 0.3 mm: through a plate thinner than both overlaps they touch each other.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double thick = GENERATE(0.0, 1e-4, 1e-3);
  const auto outcome = [&](bool above, bool below) {
    Scene scene = plain_scene(2e-6);
    scene.pairs.assign(4, {0.5, 0.3, 0.01});
    scene.walls = box({0.06, 0.06, 0.2});
    TriangleMesh plate = tiled_square(0.1, 11, thick / 2);
    if (thick > 0) plate = joined(plate, flipped(tiled_square(0.1, 7, -thick / 2)));
    scene.walls.push_back({"plate", plate, Fixed{}, 1});
    std::vector<NewRock> rocks;
    for (NewRock& s : cloud({{5, 5, 2}, 0.022, 0.0095, 0.5})) {
      const NewRock one = s;
      if (above) {
        rocks.push_back(one);
        rocks.back().particles[0].position.z += 0.026;
        rocks.back().particles[0].velocity.z = -3;
      }
      if (below) {
        rocks.push_back(one);
        rocks.back().particles[0].id += 1000;
        rocks.back().particles[0].position.z -= 0.026;
        rocks.back().particles[0].velocity.z = 3;
      }
    }
    const auto dem = make_cpu_dem(scene, precision, 1);
    dem->insert(rocks);
    std::int64_t step = 0;
    run(*dem, scene.dt, step, 5000);
    CHECK(std::abs(dem->energy().residual()) < 0.02 * dem->energy().exchanged);
    return dem->particles();
  };
  const ParticleSnapshot both = outcome(true, true), top = outcome(true, false), bottom = outcome(false, true);
  REQUIRE(both.size() == top.size() + bottom.size());
  double lowest = 1;
  for (std::size_t k = 0; k < both.size(); ++k) {
    const bool is_top = k < top.size();
    const ParticleSnapshot& alone = is_top ? top : bottom;
    const std::size_t row = is_top ? k : k - top.size();
    if (thick > 5e-4) CHECK(same(both.position[k], alone.position[row]));
    lowest = std::min(lowest, (is_top ? 1 : -1) * both.position[k].z / both.radius[k]);
  }
  CHECK(lowest > 0.5);  // all spheres stay on their side
}

TEST_CASE("H21 H22 a floor with bad triangles acts as one without", "[hard]") {
  // Repeated, flipped and flat triangles, T-junctions, slivers of 1:1e6, one triangle of a kilometre.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const auto outcome = [&](bool bad) {
    Scene scene = plain_scene(5e-6);
    scene.gravity = {0, 0, -9.81};
    scene.pairs.assign(4, {0.4, 0.5, 0.01});
    TriangleMesh floor = tiled_square(1, 2);
    if (bad) {
      floor = tiled_square(1, 6);
      const auto corner = [&](double x, double y) {
        floor.vertices.push_back({x, y, 0});
        return static_cast<Index>(floor.vertices.size()) - 1;
      };
      for (std::size_t k = 0; k < 20; ++k) {
        const Vec3<Index> t = floor.triangles[k];
        floor.triangles.push_back({t.y, t.x, t.z});  // repeated and flipped
        floor.triangles.push_back({t.x, t.x, t.y});  // flat
      }
      floor.triangles.push_back({corner(-1000, -1000), corner(1000, -900), corner(0, 1000)});          // huge, coplanar
      floor.triangles.push_back({corner(-0.9, 0.01), corner(0.9, 0.01), corner(0.9, 0.01 + 1.8e-6)});  // needle
      const Index middle = corner(0.05, 0.05);  // inside a triangle: T-junctions on all sides
      floor.triangles.push_back({middle, corner(0.3, 0.05), corner(0.05, 0.3)});
    }
    scene.walls = {{"floor", floor, Fixed{}, 1}};
    const auto dem = make_cpu_dem(scene, precision, 1);
    std::vector<NewRock> spheres;
    for (int k = 0; k < 12; ++k)
      spheres.push_back(sphere(static_cast<ParticleId>(k), {-0.5 + 0.09 * k, 0.02 * (k % 3), 0.0101},
                               {1.5, 0.2 * (k % 4), -0.3}, 0.01, 2600, {3, 4, 5}));
    dem->insert(spheres);
    std::int64_t step = 0;
    run(*dem, scene.dt, step, 4000);
    return dem->particles();
  };
  const ParticleSnapshot good = outcome(false), bad = outcome(true);
  for (std::size_t k = 0; k < good.size(); ++k) {
    CHECK(norm(good.position[k] - bad.position[k]) < 1e-9);
    CHECK(norm(good.angular_velocity[k] - bad.angular_velocity[k]) < 1e-5);
  }
}
