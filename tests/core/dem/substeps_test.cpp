// SPDX-License-Identifier: GPL-3.0-or-later
// Contact and wall forces held over several steps of the bonds, which each rock has of its own.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/plate_crush.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include "core/base/errors.hpp"

#include <array>
#include <cmath>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr double radius = 0.01, speed = 1;

/// Two spheres side by side that a soft bond joins: a rock that meets a wall, or another one, as its spheres would
/// alone, because the bond is never strained.
NewRock dumbbell(RockId id, double z, double velocity, int substeps) {
  NewRock rock = placed(bonded_pair({0, 0, 0}, {0, 0, 0}, 1, {4 * radius, 0.2 * radius}), id,
                        2 * static_cast<ParticleId>(id), {0, 0, z});
  for (NewParticle& p : rock.particles) {
    p.radius = radius;
    p.velocity = {0, 0, velocity};
  }
  rock.substeps = substeps;
  return rock;
}

/// An impact, seen by who moves along.
struct Impact {
  int substeps = 1, of_other = 1;
  double steps = 40;  ///< of the scene, in the duration of an elastic impact on a wall
  double frame = 0;   ///< velocity of all of it [m/s]

  /// Speed of rebound over that of approach.
  double on_wall(Precision precision) const {
    Scene scene = elastic_scene();
    scene.walls = {floor_plane()};
    scene.walls[0].motion = LinearMotion{{0, 0, frame}};
    const auto dem = make_cpu_dem(scene, precision, 1);
    dem->insert(std::array{dumbbell(0, 1.2 * radius, frame - speed, substeps)});
    run_through(*dem, scene.dt);
    return (dem->particles().velocity[0].z - frame) / speed;
  }
  double of_two(Precision precision) const {
    const Scene scene = elastic_scene();
    const auto dem = make_cpu_dem(scene, precision, 1);
    dem->insert(std::array{dumbbell(0, 2.2 * radius, frame - speed, substeps), dumbbell(1, 0, frame, of_other)});
    run_through(*dem, scene.dt);
    const ParticleSnapshot s = dem->particles();
    return (s.velocity[0].z - s.velocity[2].z) / speed;
  }

 private:
  Scene elastic_scene() const {
    const Material material = elastic(1.5e9, 0.35, rock_density);
    BondParameters bonds = paper_bonds();
    bonds.normal_stiffness *= 1e-3;
    bonds.shear_stiffness *= 1e-3;
    Scene scene = bonded_scene(impact_on_wall(material, radius, speed).duration / steps, bonds);
    scene.materials[0] = material;
    scene.materials[1] = rigid();
    return scene;
  }
  static void run_through(Dem& dem, double dt) {
    std::int64_t step = 0;
    run(dem, dt, step, std::llround(4 * radius / speed / dt), 20);
  }
};

struct Crush {
  double work, residual;  ///< [J]
  std::int64_t broken;
};

/// @param substeps  of the rock in a step of the scene
/// @param dt        of the bonds [s]
Crush crush(int substeps, double dt) {
  PlateCrush crush(dt * substeps);
  crush.scene.substeps = substeps;
  const auto dem = make_cpu_dem(crush.scene, Precision::double_, 1);
  dem->insert(std::vector{crush.rock});
  std::int64_t step = 0;
  run(*dem, crush.scene.dt, step, std::llround(PlateCrush::duration / crush.scene.dt), 400 / substeps);
  const EnergyTerms e = dem->energy();
  return {e.wall_work, e.residual(), dem->counts().broken_tension + dem->counts().broken_shear};
}

}  // namespace

TEST_CASE("Held forces neither add nor remove energy in an elastic impact", "[dem][hold]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  for (const int substeps : {1, 2, 4, 8}) {
    INFO(substeps << " sub-steps");
    CHECK(Impact{.substeps = substeps}.on_wall(precision) == Approx(1).margin(1e-3));
    for (const int other : {1, 3, 8}) {
      INFO("and " << other << " of the other rock");
      CHECK(Impact{.substeps = substeps, .of_other = other}.of_two(precision) == Approx(1).margin(1e-3));
    }
  }
}

TEST_CASE("Held forces act as a leapfrog with the step of the scene", "[dem][hold]") {
  // So the error of an impact depends on that step alone, not on the sub-steps.
  const double whole = Impact{.steps = 12}.on_wall(Precision::double_);
  REQUIRE(std::abs(whole - 1) > 1e-6);
  for (const int substeps : {3, 5, 9})
    CHECK(Impact{.substeps = substeps, .steps = 12}.on_wall(Precision::double_) ==
          Approx(1).margin(3 * std::abs(whole - 1)));
}

TEST_CASE("An impact of rocks with different sub-steps does not depend on who looks at it", "[dem][hold]") {
  // Rocks are seen at different times, a shift of their distance that is constant for a constant velocity.
  for (const double frame : {-20.0, 20.0}) {
    INFO("frame moves at " << frame << " m/s");
    CHECK(Impact{.substeps = 8, .of_other = 1, .frame = frame}.of_two(Precision::double_) == Approx(1).margin(1e-3));
    CHECK(Impact{.substeps = 8, .frame = frame}.on_wall(Precision::double_) == Approx(1).margin(1e-3));
  }
}

TEST_CASE("A rock crushed with held forces breaks as one without, and its energies add up", "[dem][hold][ledger]") {
  const double dt = 2e-6;
  const Crush each = crush(1, dt);
  for (const int substeps : {2, 4, 8}) {
    const Crush held = crush(substeps, dt);
    INFO(substeps << " sub-steps: work " << held.work << " J, residual " << held.residual / held.work << ", "
                  << held.broken << " bonds; one: " << each.work << " J, " << each.broken << " bonds");
    CHECK(std::abs(held.residual) < 1e-2 * held.work);
    CHECK(held.work == Approx(each.work).epsilon(0.25));
    CHECK(static_cast<double>(held.broken) == Approx(static_cast<double>(each.broken)).epsilon(0.25));
  }
}

TEST_CASE("Bond steps are counted with the sub-steps of each rock", "[dem][hold]") {
  Scene scene = bonded_scene(1e-6, paper_bonds());
  scene.substeps = 4;
  const auto dem = make_cpu_dem(scene, Precision::mixed, 1);
  std::array rocks{placed(chain(0, 3), 0, 0, {0, 0, 0}), placed(chain(1, 5), 1, 10, {0, 0, 1})};
  rocks[1].substeps = 2;
  dem->insert(rocks);
  dem->advance({0, 10, scene.dt}, {});
  CHECK(dem->counts().bond_steps == 10 * (3 * 4 + 5 * 2));
  CHECK(dem->counts().particle_steps == 10 * 10);
}
