// SPDX-License-Identifier: GPL-3.0-or-later
// The engine as a whole on scenes with known answers, in both precisions.
#include "tests/catch.hpp"
#include "tests/core/dem/scenes.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

double kinetic_and_elastic(const Dem& dem) {
  const EnergyTerms e = dem.energy();
  return e.kinetic + e.bond_elastic;
}

Vec3d angular_momentum(const ParticleSnapshot& s) {
  Vec3d l{0, 0, 0};
  for (std::size_t k = 0; k < s.size(); ++k)
    l += s.mass[k] * cross(s.position[k], s.velocity[k]) +
         0.4 * s.mass[k] * s.radius[k] * s.radius[k] * s.angular_velocity[k];
  return l;
}

}  // namespace

TEST_CASE("A free spinning rock neither heats nor drifts", "[dem][bond]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double d = 0.025, dt = 2e-6;
  Scene scene = plain_scene(dt);
  scene.bonds = paper_bonds();
  const auto dem = make_cpu_dem(scene, precision, 1);
  std::vector<NewRock> rocks{lattice_rock(0, 4, d, d / 4, 2600)};
  const Vec3d angular_velocity = GENERATE(Vec3d{30, 60, 80}, Vec3d{0.3, 0.6, 0.8});
  set_rigid_motion(rocks[0], {1, 2, 3}, angular_velocity);
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, dt, step, 1);
  const Vec3d l0 = angular_momentum(dem->particles()), p0 = dem->momentum();
  const double e0 = kinetic_and_elastic(*dem);
  run(*dem, dt, step, 20000);
  const ParticleSnapshot s = dem->particles();
  const double tolerance = precision == Precision::double_ ? 1e-12 : 1e-6;
  CHECK(norm(angular_momentum(s) - l0) / norm(l0) < tolerance);
  CHECK(norm(dem->momentum() - p0) / norm(p0) < tolerance);
  CHECK(std::abs(kinetic_and_elastic(*dem) / e0 - 1) < 2e-6);
  CHECK(dem->counts().bonds_intact == 144);
}

TEST_CASE("A wave runs along a bar of bonded spheres", "[dem][bond]") {
  const double d = 0.025, rb = 0.005, dt = 1e-6;
  Scene scene = plain_scene(dt);
  scene.bonds = paper_bonds();
  scene.bonds->damping = 0;
  const auto dem = make_cpu_dem(scene, Precision::double_, 1);
  // Axial wave: a bar of spheres, the first is hit; the front runs at L sqrt(kn A/m).
  NewRock bar;
  bar.id = 0;
  const int n = 60;
  for (int k = 0; k < n; ++k)
    bar.particles.push_back({ParticleId(k), {k * d, 0, 0}, {0, 0, 0}, {0, 0, 0}, d / 2, 2600});
  bar.colour_begin = {0};
  for (int odd = 0; odd < 2; ++odd) {
    for (int k = odd; k + 1 < n; k += 2) bar.bonds.push_back({k, k + 1, d, rb, 1});
    bar.colour_begin.push_back(static_cast<Index>(bar.bonds.size()));
  }
  for (int k = 0; k < 30; ++k)
    bar.particles[std::size_t(k)].velocity = {0.01, 0, 0};  // the left half flies into the right
  const std::vector<NewRock> bars{bar};
  dem->insert(bars);
  const double mass = 2600 * 4.0 / 3 * M_PI * std::pow(d / 2, 3), area = M_PI * rb * rb;
  const double speed = d * std::sqrt(1.67e12 * area / mass);
  CHECK(speed == Approx(1963.12).epsilon(1e-4));
  std::int64_t step = 0;
  double reached = 0;
  while (reached == 0 && step < 2000) {
    run(*dem, dt, step, 1);
    // The front carries half the impact speed; it starts between spheres 29 and 30.
    if (dem->particles().velocity[50].x > 0.0025) reached = static_cast<double>(step) * dt;
  }
  // From 29.5 to 50 at half height; the discrete front lags by a fraction of a cell.
  CHECK(20.5 * d / reached == Approx(speed).epsilon(0.03));
}
