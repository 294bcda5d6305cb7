// SPDX-License-Identifier: GPL-3.0-or-later
// Failure of bonds in the engine: energy, forces, and the contact of the pair afterwards.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "tests/catch.hpp"

#include <iterator>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr double d = grain;

Scene bond_scene(double dt) {
  return bonded_scene(dt, paper_bonds(), {0.5, 1, 0});
}

}  // namespace

TEST_CASE("A bond that fails in tension releases the energy that it stored", "[dem][bond]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double v = 2, dt = 2e-8, strength = GENERATE(0.5, 1.0);
  Scene scene = bond_scene(dt);
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{bonded_pair({-v, 0, 0}, {v, 0, 0}, strength)};
  dem->insert(rocks);
  const double kinetic = dem->energy().kinetic;
  std::int64_t step = 0;
  run(*dem, dt, step, 2000);
  const std::vector<Breakage> broken = dem->take_breakages();
  REQUIRE(broken.size() == 1);
  CHECK(broken[0].mode == BreakMode::tension);
  CHECK(broken[0].i == 0);
  CHECK(broken[0].j == 1);
  CHECK(broken[0].rock == 0);
  // 1/2 F u at F = 2827.433 N, u = 21.5569 um, times the square of the strength; the step overshoots.
  const double exact = 0.5 * 2827.433 * 21.5569e-6 * strength * strength;
  CHECK(broken[0].energy >= exact * 0.99999);
  CHECK(broken[0].energy < exact * (1 + 2 * 2 * v * dt / (21.5569e-6 * strength)));
  const EnergyTerms e = dem->energy();
  CHECK(e.bond_breakage == broken[0].energy);
  CHECK(e.bond_elastic == 0);
  CHECK(kinetic - e.kinetic == Approx(exact).epsilon(0.02));
  CHECK(std::abs(e.residual()) < 0.01 * exact);
  CHECK(dem->counts().bonds_intact == 0);
  CHECK(dem->counts().broken_tension == 1);
  CHECK(dem->take_breakages().empty());
  CHECK(dem->particles().fragment == std::vector<Index>{0, 1});
}

TEST_CASE("Shear failure in compression does not change the normal force", "[dem][bond]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double dt = 2e-8;
  Scene scene = bond_scene(dt);
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{bonded_pair({0.5, -2, 0}, {-0.5, 2, 0}, 0.5)};
  dem->insert(rocks);
  std::int64_t step = 0;
  double before = 0, change_before = 0, jump = -1;
  while (dem->counts().bonds_intact == 1 && step < 2000) {
    run(*dem, dt, step, 1);
    const ParticleSnapshot s = dem->particles();
    const Vec3d span = s.position[1] - s.position[0];
    const double push = dot(s.force[1], span) / norm(span);
    change_before = push - before;
    before = push;
  }
  const std::vector<Breakage> broken = dem->take_breakages();
  REQUIRE(broken.size() == 1);
  CHECK(broken[0].mode == BreakMode::shear);
  REQUIRE(before > 100);
  run(*dem, dt, step, 1);
  const ParticleSnapshot s = dem->particles();
  const Vec3d span = s.position[1] - s.position[0], n = (1 / norm(span)) * span;
  jump = dot(s.force[1], n) - before;
  CHECK(std::abs(jump) < 2 * std::abs(change_before));
  CHECK(norm(tangential(s.force[1], n)) <= 0.5 * dot(s.force[1], n) * (1 + 1e-5));
  const double work = 4 * 0.5 * s.mass[0];  // of the order of the energies in the scene
  CHECK(std::abs(dem->energy().residual()) < 0.01 * work);
}

TEST_CASE("A bond under compression and shear breaks at the force of its failure criterion", "[dem][bond]") {
  // Ends of fixed speed, without rotation: both loads grow evenly. Rb = 5 mm, tau_c = 24 MPa, phi = 30 deg.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const bool mohr = GENERATE(false, true);
  const double dt = 1e-6, area = 78.539816e-6, cohesion = 24e6 * area, tan_phi = mohr ? 0.5773502692 : 0;
  Scene scene = bond_scene(dt);
  scene.bond_model.failure = mohr ? BondFailure::mohr_coulomb : BondFailure::constant;
  scene.bonds->internal_friction = 0.5773502692;  // without effect on constant strength
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{bonded_pair({}, {-0.002, 0.006, 0}, 1, {.density = immovable})};
  dem->insert(rocks);
  std::int64_t step = 0;
  double push = 0, shear = 0;
  while (dem->counts().bonds_intact == 1 && step < 20000) {
    run(*dem, dt, step, 1);
    const ParticleSnapshot s = dem->particles();
    const Vec3d span = s.position[1] - s.position[0], n = (1 / norm(span)) * span;
    push = dot(s.force[1], n);  // the step of failure has the loads of the intact bond
    shear = norm(tangential(s.force[1], n));
  }
  REQUIRE(dem->take_breakages().at(0).mode == BreakMode::shear);
  const double growth = 2.0 / static_cast<double>(step);  // loads per step, at least
  CHECK(push > 0.6 * cohesion);
  CHECK(shear >= (cohesion + tan_phi * push) * (1 - 1e-5));
  CHECK(shear < (cohesion + tan_phi * push) * (1 + growth));
  CHECK(dem->bonds().i.empty());
}

TEST_CASE("A pair whose bond is broken touches as spheres do, before the lists are rebuilt", "[dem][bond][contact]") {
  // Sheared apart while pressed, or torn; the right one rebounds from a wall and hits the left one.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const bool torn = GENERATE(true, false);
  const double dt = 2e-7;
  Scene scene = bond_scene(dt);
  scene.pairs.assign(4, {0, 1, 0});
  scene.bonds->tensile_strength = torn ? 1e3 : 1e12;
  scene.bonds->shear_strength = torn ? 1e12 : 1e3;
  scene.neighbour_skin = 0.1;
  scene.walls = {{"right", PlaneShape{{1.5 * d + 1e-4, 0, 0}, {-1, 0, 0}}, Fixed{}, 1}};
  const auto dem = make_cpu_dem(scene, precision, 1);
  const Vec3d v_j = torn ? Vec3d{2, 0, 0} : Vec3d{-2, 1e-3, 0};
  const std::vector<NewRock> rocks{bonded_pair({0, 0, 0}, v_j)};
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, dt, step, 10);
  REQUIRE(dem->counts().bonds_intact == 0);
  const double kinetic = dem->energy().kinetic;
  const std::int64_t rebuilds = dem->counts().rebuilds;
  double nearest = 1, apart = 0;
  for (int k = 0; k < 300; ++k) {
    run(*dem, dt, step, 20);
    const ParticleSnapshot s = dem->particles();
    const double distance = norm(s.position[1] - s.position[0]);
    apart = std::max(apart, distance);
    if (apart > d * (1 + 1e-6)) nearest = std::min(nearest, distance);
  }
  CHECK(dem->counts().rebuilds == rebuilds);
  const ParticleSnapshot s = dem->particles();
  if (torn) {
    // An elastic central impact hands the velocity over, at Hertz's depth for two equal spheres.
    const ElasticImpact hertz(youngs_of_pair(scene.materials[0]), d / 4, s.mass[0] / 2, 2);
    CHECK(d - nearest == Approx(hertz.overlap).epsilon(0.02));
    CHECK(s.velocity[0].x == Approx(-2).epsilon(0.01));
    CHECK(std::abs(s.velocity[1].x) < 0.02);
  }
  CHECK(dem->energy().kinetic == Approx(kinetic).epsilon(torn ? 1e-3 : 1.0));
  CHECK(std::abs(dem->energy().residual()) < 1e-3 * 0.5 * s.mass[0] * 4);
}

TEST_CASE("Breaking every bond at once without load sets no particle in motion", "[dem][bond]") {
  // Packed with overlap, touching, or with gaps: full contact forces at 10 % overlap of the radius
  // would throw the spheres apart at metres per second.
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double spacing = GENERATE(0.95, 1.0, 1.02);
  const double dt = 5e-7, speed = 1e-5;
  Scene scene = bond_scene(dt);
  scene.pairs.assign(4, {0.5, 0.25, 0});
  NewRock rock = lattice(0, 3, {.bond_radius = grain / 4});
  for (NewParticle& p : rock.particles) {
    p.position = spacing * p.position;
    p.velocity = speed * random_vector(p.id, 0);
  }
  for (NewBond& b : rock.bonds) {
    b.length = spacing * d;
    b.strength = 1e-8;
  }
  const auto dem = make_cpu_dem(scene, precision, 1);
  const std::vector<NewRock> rocks{rock};
  dem->insert(rocks);
  const double kinetic = dem->energy().kinetic;
  std::int64_t step = 0;
  run(*dem, dt, step, 4000);
  CHECK(dem->counts().bonds_intact == 0);
  CHECK(dem->take_breakages().size() == rock.bonds.size());
  const EnergyTerms e = dem->energy();
  CHECK(e.kinetic < 1.02 * kinetic);
  CHECK(e.bond_elastic < 0.02 * kinetic);
  CHECK(std::abs(e.residual()) < 0.05 * kinetic);
}
