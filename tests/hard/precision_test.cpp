// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of numbers: small steps far from the origin, small overlaps, long clocks.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

TEST_CASE("H23 slow spheres far from the origin move by velocity times time", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double speed = GENERATE(1e-4, 0.01, 0.1, 0.238, 0.3, 0.5, 2.0), origin = GENERATE(3.0, 1000.0);
  Scene scene = plain_scene(5e-7);
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> one{sphere(0, {origin, -origin, origin}, {speed, speed, -speed}, 0.01, 2600)};
  dem->insert(one);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 10000);
  const ParticleSnapshot s = dem->particles();
  const double path = speed * 10000 * scene.dt, rounding = 10000 * 1.2e-16 * origin;
  CHECK(s.position[0].x - origin == Approx(path).margin(rounding));
  CHECK(s.position[0].y + origin == Approx(path).margin(rounding));
  CHECK(s.position[0].z - origin == Approx(-path).margin(rounding));
}

TEST_CASE("H24 free fall of 0.4 s gains g t to rounding", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  Scene scene = plain_scene(5e-7);
  scene.gravity = {0, 0, -9.81};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> one{sphere(0, {0, 0, 3}, {0, 0, 0}, 0.01, 2600)};
  dem->insert(one);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 800000, 100000);
  const ParticleSnapshot s = dem->particles();
  CHECK(s.velocity[0].z == Approx(-9.81 * 0.4).epsilon(1e-11));
  CHECK(3 - s.position[0].z == Approx(0.5 * 9.81 * 0.16).epsilon(1e-11));
}

TEST_CASE("H25 a small overlap far from the origin has the right force", "[hard]") {
  // The positions are exact in binary; the radii make the overlap.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double ratio = GENERATE(1e-6, 1e-5, 1e-3), origin = GENERATE(0.0, 3.0, 30.0);
  Scene scene = plain_scene(1e-9);
  const double distance = 0.03125, radius = distance / (2 - ratio);
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> two{sphere(0, {origin, origin, origin}, {0, 0, 0}, radius, 2600),
                                 sphere(1, {origin + distance, origin, origin}, {0, 0, 0}, radius, 2600)};
  dem->insert(two);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 1);
  const double overlap = 2 * radius - distance;
  const double force = 4.0 / 3 * youngs_of_pair(scene.materials[0]) * std::sqrt(radius / 2) * std::pow(overlap, 1.5);
  // An error of 1e-7 R in the overlap would be 1.5e-7/ratio of the force. Positions in double leave 1e-14 of it.
  const double tolerance = (precision == Precision::double_ ? 1e-9 : 3e-7) + 1.5 * 4e-16 * (origin + 1) / overlap;
  CHECK(dem->particles().force[1].x == Approx(force).epsilon(tolerance));
}

TEST_CASE("H36 after 1e9 steps time equals steps times dt", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const std::int64_t first = GENERATE(std::int64_t{100'000'000}, std::int64_t{20'000'000'000});
  const double dt = 3e-7;
  const Window late{first, 100, dt};
  CHECK(late.begin() == static_cast<double>(first) * dt);
  CHECK(late.end() - late.begin() == Approx(100 * dt).epsilon(1e-7));
  // A moving plate and bonds that break: both compute the time only from the count of steps.
  Scene scene = plain_scene(dt);
  scene.bonds = paper_bonds();
  scene.walls = {{"plate", PlaneShape{{0, 0, 0}, {0, 0, 1}}, LinearMotion{{0, 0, 1e-6}}, 1}};
  NewRock rock = lattice(0, 2);
  for (NewParticle& p : rock.particles) {
    p.position.z += 1;
    p.velocity = 400.0 * p.position;
    p.velocity.z -= 400;
  }
  const std::vector<NewRock> rocks{rock};
  const auto dem = make_cpu_dem(scene, precision, 1);
  dem->insert(rocks);
  std::int64_t step = first;
  run(*dem, dt, step, 1000, 100);
  CHECK(dem->wall_poses()[0].origin.z == static_cast<double>(first + 1000) * dt * 1e-6);
  const std::vector<Breakage> broken = dem->take_breakages();
  REQUIRE(broken.size() == rock.bonds.size());
  for (const Breakage& b : broken) {
    const double steps = b.time / dt;
    CHECK(std::abs(steps - std::round(steps)) < 1e-3);
    CHECK(b.time > late.begin());
    CHECK(b.time <= static_cast<double>(first + 1000) * dt);
  }
}
