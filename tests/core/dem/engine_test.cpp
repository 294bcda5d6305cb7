// SPDX-License-Identifier: GPL-3.0-or-later
// The engine as a whole on scenes with known answers, in both precisions.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

double kinetic_and_elastic(const Dem& dem) {
  const EnergyTerms e = dem.energy();
  return e.kinetic + e.bond_elastic;
}

}  // namespace

TEST_CASE("A free rotating rock keeps its energy and momenta", "[dem][bond]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double dt = 2e-6;
  Scene scene = plain_scene(dt);
  scene.bonds = paper_bonds();
  const auto dem = make_cpu_dem(scene, precision, 1);
  std::vector<NewRock> rocks{lattice(0, 4, {.bond_radius = grain / 4})};
  const Vec3d angular_velocity = GENERATE(Vec3d{30, 60, 80}, Vec3d{0.3, 0.6, 0.8});
  add_rigid_motion(rocks[0], {1, 2, 3}, angular_velocity);
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
  const double dt = 1e-6;
  Scene scene = plain_scene(dt);
  scene.bonds = paper_bonds();
  const auto dem = make_cpu_dem(scene, Precision::double_, 1);
  // The left half of a bar flies into the right one; the front runs at L sqrt(kn A/m).
  NewRock bar = chain(0, 59);
  for (std::size_t k = 0; k < 30; ++k) bar.particles[k].velocity = {0.01, 0, 0};
  dem->insert(std::vector{bar});
  const double speed = grain * std::sqrt(BondStiffness(*scene.bonds).normal / sphere_mass(grain / 2, rock_density));
  CHECK(speed == Approx(1963.12).epsilon(1e-4));
  std::int64_t step = 0;
  double reached = 0;
  while (reached == 0 && step < 2000) {
    run(*dem, dt, step, 1);
    // The front carries half the impact speed; it starts between spheres 29 and 30.
    if (dem->particles().velocity[50].x > 0.0025) reached = static_cast<double>(step) * dt;
  }
  // From 29.5 to 50 at half height; the discrete front lags by a fraction of a cell.
  CHECK(20.5 * grain / reached == Approx(speed).epsilon(0.03));
}
