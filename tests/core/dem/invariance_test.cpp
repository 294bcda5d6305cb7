// SPDX-License-Identifier: GPL-3.0-or-later
// Invariances of mechanics: frame, rotation, mirror, time, and the momenta of a closed system.
#include "tests/catch.hpp"
#include "tests/core/dem/scenes.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

constexpr double d = 0.025, dt = 2e-6;

Scene free_scene() {
  Scene scene = plain_scene(dt);
  scene.pairs.assign(4, {0.5, 0.25, 0.02});
  scene.rolling = true;
  scene.bonds = paper_bonds();
  scene.bonds->damping = 0.05;
  return scene;
}

/// Two turned rocks that collide off centre, and three spheres in their way.
std::vector<NewRock> collision(const Quatd& turn = {1, 0, 0, 0}, Vec3d drift = {0, 0, 0}) {
  const NewRock block = lattice_rock(0, 3, d, d / 4, 2600);
  std::vector<NewRock> rocks{placed(block, 0, 0, {-0.047, 0.01, 0}, rotation_about({0.6, 0, 0.8}, 0.4)),
                             placed(block, 1, 100, {0.047, -0.01, 0.005}, rotation_about({0, 0.6, 0.8}, 0.7))};
  for (NewParticle& p : rocks[0].particles) p.velocity = {2, 0, 0};
  for (NewParticle& p : rocks[1].particles) p.velocity = {-2, 0, 0.1};
  for (ParticleId k = 0; k < 3; ++k)
    rocks.push_back(sphere(200 + k, {0.002 * k, 0.09 * (k - 1.0) + 0.01, 0.03}, {0, -0.5 * (k - 1.0), -0.5}, 0.01, 2600,
                           {10, 20, 30}));
  for (NewRock& rock : rocks)
    for (NewParticle& p : rock.particles) {
      p.position = rotate(turn, p.position);
      p.velocity = rotate(turn, p.velocity) + drift;
      p.spin = rotate(turn, p.spin);
    }
  return rocks;
}

ParticleSnapshot after(const Scene& scene, Loads loads, const std::vector<NewRock>& rocks, int steps) {
  const auto dem = make_cpu_dem(scene, loads, 1);
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, scene.dt, step, steps);
  return dem->particles();
}

double largest(const ParticleSnapshot& a, const ParticleSnapshot& b,
               const std::vector<Vec3d> ParticleSnapshot::*column) {
  double most = 0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, norm((a.*column)[k] - (b.*column)[k]));
  return most;
}
double size_of(const std::vector<Vec3d>& v) {
  double most = 0;
  for (const Vec3d& x : v) most = std::max(most, norm(x));
  return most;
}

}  // namespace

TEST_CASE("A drift of the whole scene changes no force", "[dem][invariance]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const ParticleSnapshot a = after(free_scene(), loads, collision(), 3000);
  ParticleSnapshot b = after(free_scene(), loads, collision({1, 0, 0, 0}, {10, -10, 5}), 3000);
  REQUIRE(size_of(a.force) > 10);
  for (std::size_t k = 0; k < b.size(); ++k) b.position[k] -= (3000 * dt) * Vec3d{10, -10, 5};
  const double exact = loads == Loads::double_ ? 1e-9 : 1e-3;
  // Places round at 1e-17 m here, which a bond of 2e8 N/m turns into 2e-9 N; a sphere has up to six.
  CHECK(largest(a, b, &ParticleSnapshot::force) < exact * size_of(a.force) + 6 * 2e-9);
  CHECK(largest(a, b, &ParticleSnapshot::position) < exact * d);
}

TEST_CASE("A rotation of the whole scene rotates its course", "[dem][invariance]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const Quatd q = normalised(Quatd{0.3, -0.5, 0.7, 0.2});
  ParticleSnapshot a = after(free_scene(), loads, collision(), 5000);
  const ParticleSnapshot b = after(free_scene(), loads, collision(q), 5000);
  for (std::size_t k = 0; k < a.size(); ++k) {
    a.position[k] = rotate(q, a.position[k]);
    a.spin[k] = rotate(q, a.spin[k]);
  }
  const double exact = loads == Loads::double_ ? 1e-8 : 1e-3;
  CHECK(largest(a, b, &ParticleSnapshot::position) < exact * d);
  CHECK(largest(a, b, &ParticleSnapshot::spin) < exact * size_of(a.spin));
}

TEST_CASE("A mirrored scene takes the mirrored course", "[dem][invariance]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  std::vector<NewRock> rocks = collision(), mirrored = rocks;
  for (NewRock& rock : mirrored)
    for (NewParticle& p : rock.particles) {
      p.position.x = -p.position.x;
      p.velocity.x = -p.velocity.x;
      p.spin = {p.spin.x, -p.spin.y, -p.spin.z};
    }
  const ParticleSnapshot a = after(free_scene(), loads, rocks, 4000);
  ParticleSnapshot b = after(free_scene(), loads, mirrored, 4000);
  for (std::size_t k = 0; k < b.size(); ++k) b.position[k].x = -b.position[k].x;
  CHECK(largest(a, b, &ParticleSnapshot::position) < (loads == Loads::double_ ? 1e-10 : 1e-4) * d);
}

TEST_CASE("Smooth elastic spheres find their way back in reversed time", "[dem][invariance]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const int steps = 1000;
  Scene scene = plain_scene(1e-5);
  scene.gravity = {0, 0, -9.81};
  scene.walls = box({0.06, 0.06, 0.06});
  std::vector<NewRock> rocks = cloud(3, 3, 3, 0.03, 0.012, 2.0);
  const ParticleSnapshot there = after(scene, loads, rocks, steps);
  std::vector<NewRock> back;
  for (std::size_t k = 0; k < there.size(); ++k) {
    back.push_back(rocks[k]);
    back[k].particles[0].position = there.position[k];
    back[k].particles[0].velocity = -there.velocity[k];
    back[k].particles[0].spin = -there.spin[k];
  }
  const ParticleSnapshot home = after(scene, loads, back, steps);
  const double exact = loads == Loads::double_ ? 1e-8 : 1e-3;
  double moved = 0;
  for (std::size_t k = 0; k < home.size(); ++k) {
    const NewParticle& start = rocks[k].particles[0];
    moved = std::max(moved, norm(there.velocity[k] - start.velocity));
    CHECK(norm(home.position[k] - start.position) < exact * 0.012);
  }
  CHECK(moved > 1);  // they did collide
}

TEST_CASE("A closed system keeps both momenta", "[dem][invariance]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  Scene scene = free_scene();
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 2e6;
  const auto dem = make_cpu_dem(scene, loads, 1);
  dem->insert(collision());
  const auto angular = [](const ParticleSnapshot& s) {
    Vec3d l{0, 0, 0};
    for (std::size_t k = 0; k < s.size(); ++k)
      l += s.mass[k] * cross(s.position[k], s.velocity[k]) + 0.4 * s.mass[k] * s.radius[k] * s.radius[k] * s.spin[k];
    return l;
  };
  const Vec3d p0 = dem->momentum(), l0 = angular(dem->particles());
  std::int64_t step = 0;
  run(*dem, scene.dt, step, 5000);
  CHECK(dem->counts().broken_tension + dem->counts().broken_shear > 5);
  const double momentum = 27 * sphere_mass(d / 2, 2600) * 2;  // of one rock
  const double exact = loads == Loads::double_ ? 1e-12 : 1e-6;
  CHECK(norm(dem->momentum() - p0) < exact * momentum);
  CHECK(norm(angular(dem->particles()) - l0) < exact * momentum * 0.05);
  CHECK(std::abs(dem->energy().residual()) < 5e-3 * dem->energy().exchanged);
}
