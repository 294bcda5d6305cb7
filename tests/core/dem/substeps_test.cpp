// SPDX-License-Identifier: GPL-3.0-or-later
// Contact and wall forces held over several steps of the bonds.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/plate_crush.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include "core/base/errors.hpp"

using namespace gyro;
using namespace gyro::fixtures;

namespace {

/// Speed of rebound of an elastic sphere over its speed of approach.
/// @param held_steps  holds in the duration of the impact
double rebound(Precision precision, int hold, double held_steps, bool on_wall) {
  const Material material = elastic(1.5e9, 0.35, 2600);
  const double radius = 0.01, speed = 1;
  Scene scene = plain_scene(impact_on_wall(material, radius, speed).duration / held_steps / hold);
  scene.materials[0] = material;
  scene.materials[1] = rigid();
  scene.substeps = hold;
  scene.walls = {floor_plane()};
  const auto dem = make_cpu_dem(scene, precision, 1);
  std::vector<NewRock> rocks{sphere(0, {0, 0, 1.2 * radius}, {0, 0, -speed}, radius, material.density)};
  if (!on_wall) {
    rocks[0].particles[0].position.z = 9.2 * radius;
    rocks.push_back(sphere(1, {0, 0, 7 * radius}, {0, 0, 0}, radius, material.density));
  }
  dem->insert(rocks);
  std::int64_t step = 0;
  const int steps = static_cast<int>(std::ceil(4 * radius / speed / scene.dt / hold)) * hold;
  run(*dem, scene.dt, step, steps, 20 * hold);
  const ParticleSnapshot s = dem->particles();
  return on_wall ? s.velocity[0].z / speed : -s.velocity[1].z / speed;
}

struct Crush {
  double work, residual;  ///< [J]
  std::int64_t broken;
};

/// @param hold  steps over which contact forces are held
Crush crush(int hold, double dt) {
  PlateCrush crush(dt);
  crush.scene.substeps = hold;
  const auto dem = make_cpu_dem(crush.scene, Precision::double_, 1);
  dem->insert(std::vector{crush.rock});
  std::int64_t step = 0;
  run(*dem, dt, step, std::llround(PlateCrush::duration / dt / 80) * 80, 400);
  const EnergyTerms e = dem->energy();
  return {e.wall_work, e.residual(), dem->counts().broken_tension + dem->counts().broken_shear};
}

}  // namespace

TEST_CASE("Held forces neither add nor remove energy in an elastic impact", "[dem][hold]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  for (const bool on_wall : {true, false})
    for (const int hold : {1, 2, 4, 8}) {
      INFO("hold " << hold << (on_wall ? ", on a wall" : ", two spheres"));
      CHECK(rebound(precision, hold, 40, on_wall) == Approx(1).margin(1e-3));
    }
}

TEST_CASE("Held forces act as a leapfrog with the step of the hold", "[dem][hold]") {
  // So the error of an impact depends on the hold alone, not on how many steps it has.
  const double whole = rebound(Precision::double_, 1, 12, true);
  REQUIRE(std::abs(whole - 1) > 1e-6);
  for (const int hold : {3, 5, 9})
    CHECK(rebound(Precision::double_, hold, 12, true) == Approx(1).margin(3 * std::abs(whole - 1)));
}

TEST_CASE("A rock crushed with held forces breaks as one without, and its energies add up", "[dem][hold][ledger]") {
  const double dt = 2e-6;
  const Crush each = crush(1, dt);
  for (const int hold : {2, 4, 8}) {
    const Crush held = crush(hold, dt);
    INFO("hold " << hold << ": work " << held.work << " J, residual " << held.residual / held.work << ", "
                 << held.broken << " bonds; without: " << each.work << " J, " << each.broken << " bonds");
    CHECK(std::abs(held.residual) < 1e-2 * held.work);
    CHECK(held.work == Approx(each.work).epsilon(0.25));
    CHECK(static_cast<double>(held.broken) == Approx(static_cast<double>(each.broken)).epsilon(0.25));
  }
}

TEST_CASE("A window that is not a whole number of holds is refused", "[dem][hold]") {
  Scene scene = plain_scene(1e-6);
  scene.substeps = 4;
  const auto dem = make_cpu_dem(scene, Precision::mixed, 1);
  CHECK_THROWS_AS(dem->advance({0, 6, scene.dt}, {}), BadInput);
}
