// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of contacts: fast impacts, wedges, dust in a closing gap, thousands of contacts under load.
#include "app/simulation/ledger.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// Two plates at an angle about the x axis, symmetrical to z, open at the top, with a sphere between them.
/// Both close at `speed` along their normals.
Scene wedge(double angle, double friction, double radius, double speed, double dt) {
  Scene scene = plain_scene(dt);
  scene.pairs.assign(4, {friction, 0.3, 0});
  const double half = angle / 2, c = std::cos(half), s = std::sin(half);
  for (const double side : {1.0, -1.0}) {
    const Vec3d normal{0, -side * c, s};
    scene.walls.push_back(
        {side > 0 ? "right" : "left", PlaneShape{-radius * normal, normal}, LinearMotion{speed * normal}, 1});
  }
  return scene;
}

}  // namespace

TEST_CASE("H5 the energy of impacts at 10 to 100 m/s balances, and large overlaps are flagged", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double speed = GENERATE(10.0, 50.0, 100.0), restitution = GENERATE(1.0, 0.25);
  const double radius = 0.02;
  Scene scene = plain_scene(1e-7);
  scene.pairs.assign(4, {0.5, restitution, 0});
  scene.walls = {floor_plane()};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> one{sphere(0, {0, 0, radius * 1.001}, {0, 0, -speed}, radius, 2600)};
  dem->insert(one);
  const double kinetic = dem->energy().kinetic;
  std::int64_t step = 0;
  double deepest = 0;
  for (int k = 0; k < 400; ++k) {
    run(*dem, scene.dt, step, 20);
    deepest = std::max(deepest, dem->extremes().overlap_ratio);
    if (dem->particles().position[0].z > radius && dem->particles().velocity[0].z > 0) break;
  }
  const double hertz = impact_on_wall(scene.materials[0], radius, speed).overlap / radius;
  INFO(speed << " m/s: overlap " << deepest << " R, Hertz " << hertz);
  if (restitution == 1.0) CHECK(deepest == Approx(hertz).epsilon(0.02));
  CHECK(dem->particles().velocity[0].z == Approx(restitution * speed).epsilon(5e-3));
  CHECK(std::abs(dem->energy().residual()) < 5e-3 * kinetic);
}

TEST_CASE("H9 a wedge squeezes a sphere out if and only if tan(alpha/2) > mu", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double degrees = GENERATE(20.0, 30.0, 33.0, 34.0, 60.0, 90.0), friction = GENERATE(0.1, 0.3, 0.7);
  const double angle = degrees * M_PI / 180, radius = 0.02, limit = std::tan(angle / 2);
  if (std::abs(limit / friction - 1) < 0.01) return;
  const double speed = 0.2;
  const Scene scene = wedge(angle, friction, radius, speed, 1e-6);
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> one{sphere(0, {0, 0, 0}, {0, 0, 0}, radius, 2600)};
  dem->insert(one);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 5000);  // pressed in by 1 mm, 0.05 R
  const ParticleSnapshot s = dem->particles();
  // Held: it has the overlap that the plates have imposed. Squeezed out: it moves up with the intersection of the
  // plates.
  const double overlap = dem->extremes().overlap_ratio * radius, closed = speed * 5000 * scene.dt;
  INFO("angle " << degrees << ", friction " << friction << ": overlap " << overlap << " of " << closed << ", z "
                << s.position[0].z);
  if (limit > friction) {
    CHECK(overlap < 0.5 * closed);
    CHECK(s.position[0].z > 0.5 * closed);
  } else {
    CHECK(overlap > 0.5 * closed);
  }
  // Repeating the motion lifts it by the same distance if it is squeezed out, otherwise hardly at all.
  const double z = s.position[0].z;
  run(*dem, scene.dt, step, 5000);
  const double further = (dem->particles().position[0].z - z) / closed;
  INFO("further " << further);
  CHECK((further > 0.7) == (limit > friction));
  CHECK(std::abs(s.position[0].y) < 1e-9);
  CHECK(std::abs(dem->energy().residual()) < 0.01 * std::abs(dem->energy().wall_work));
}

TEST_CASE(
    "H8 H35 a sphere in a closing gap follows Hertz's law and returns at most the stored energy, or stops the run",
    "[hard]") {
  // A grain between plates 0.5 mm apart at the end (0.5 R pressed in at each side), 0.8 mm, and 0.15 mm.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double radius = GENERATE(0.0005, 0.025), left = GENERATE(0.8, 0.5, 0.15);  // of the diameter
  Scene scene = plain_scene(radius * 1e-5);
  scene.pairs.assign(4, {0.3, 1, 0});
  const double close = 2 * radius * (1 - left), speed = 0.5;
  scene.walls = {{"mantle", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1},
                 {"concave", PlaneShape{{0, 0, 2 * radius}, {0, 0, -1}}, LinearMotion{{0, 0, -speed}}, 1}};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> one{sphere(3, {0, 0, radius}, {0, 0, 0}, radius, 2600)};
  dem->insert(one);
  Ledger ledger({.step = scene.limits}, {"mantle", "concave"});
  const int steps = 100;
  std::optional<std::string> verdict;
  std::int64_t step = 0;
  double work = 0, maximum = 0;
  while (!verdict && static_cast<double>(step) * scene.dt * speed < close) {
    ledger.open(dem->energy());
    dem->advance({step, steps, scene.dt}, {});
    step += steps;
    verdict = ledger.close(static_cast<double>(step) * scene.dt, dem->energy(), dem->extremes());
    work += dem->wall_loads()[1].work;
    maximum = std::max(maximum, norm(dem->wall_loads()[0].force));
  }
  const double overlap = speed * static_cast<double>(step) * scene.dt / 2;
  const double hertz = hertz_force(scene.materials[0], radius, overlap);
  INFO("closed by " << overlap / radius << " R a side: " << maximum << " N, Hertz " << hertz << ", "
                    << verdict.value_or("no verdict"));
  CHECK(maximum < 1.1 * hertz);
  CHECK(maximum > 0.8 * hertz);
  if (left < 0.2) {
    REQUIRE(verdict);
    CHECK(verdict->find("particle 3 with wall") != std::string::npos);
    return;
  }
  CHECK_FALSE(verdict);
  // The energy of the sphere is at most the work of the plates.
  CHECK(dem->energy().kinetic + dem->energy().contact_elastic <= work * 1.001);
  CHECK(std::abs(dem->energy().residual()) < 1e-3 * work);
}
