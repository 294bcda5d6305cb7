// SPDX-License-Identifier: GPL-3.0-or-later
// Hard cases of the time step: the engine is stable below the limit of the guard.
#include "app/simulation/time_step.hpp"
#include "app/simulation/ledger.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/rocks/bonds.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/stability.hpp"
#include "tests/catch.hpp"

#include <numbers>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

NewRock as_rock(const RockTemplate& shape) {
  NewRock rock;
  rock.id = 0;
  for (std::size_t k = 0; k < shape.centres.size(); ++k)
    rock.particles.push_back(
        {static_cast<ParticleId>(k), shape.centres[k], {0, 0, 0}, {0, 0, 0}, shape.radii[k], shape.particle_density});
  for (const TemplateBond& b : shape.bonds) rock.bonds.push_back({b.i, b.j, b.length, b.radius, 1.0});
  rock.colour_begin = shape.colour_begin;
  return rock;
}

RockTemplate bonded(std::vector<Vec3d> centres, std::vector<double> radii, const BondRule& rule) {
  RockTemplate rock;
  rock.centres = std::move(centres);
  rock.radii = std::move(radii);
  rock.particle_density = 2600;
  rock.bonds = make_bonds(rock.centres, rock.radii, rule);
  rock.colour_begin = colour_bonds(rock.bonds, static_cast<Index>(rock.centres.size()));
  return rock;
}

/// A procedural rock of particles of 25 mm.
RockTemplate mono_rock() {
  const BondRule rule{0.05, AbsoluteBondRadius{0.005}};
  const Filling f = fill(Mould(procedural_shape(1, 0)), MonoFill{6}, rule, {1, 42, 0});
  const double scale = 0.0125 / f.radii[0];
  std::vector<Vec3d> centres;
  for (const Vec3d& c : f.centres) centres.push_back(scale * c);
  return bonded(centres, std::vector<double>(centres.size(), 0.0125), rule);
}

/// One grain of 8 mm with bonds to twenty large ones around it.
RockTemplate star() {
  std::vector<Vec3d> centres{{0, 0, 0}};
  std::vector<double> radii{0.004};
  for (int k = 0; k < 20; ++k) {
    const double z = 1 - (2 * k + 1) / 20.0, r = std::sqrt(1 - z * z), azimuth = 2.399963229728653 * k;
    centres.push_back(0.024 * Vec3d{r * std::cos(azimuth), r * std::sin(azimuth), z});
    radii.push_back(0.02);
  }
  RockTemplate rock = bonded(centres, radii, {0.05, AbsoluteBondRadius{0.005}});
  std::erase_if(rock.bonds, [](const TemplateBond& b) { return b.i != 0; });
  rock.colour_begin = colour_bonds(rock.bonds, 21);
  return rock;
}

/// Grains of 4 to 22 mm radius, packed one by one around a first one; bonds of 5 mm, thicker than the smallest grain.
RockTemplate graded_rock() {
  std::vector<Vec3d> centres;
  std::vector<double> radii;
  for (std::uint64_t k = 0; centres.size() < 300; ++k) {
    const double radius = 0.004 * std::pow(5.5, 0.5 + 0.5 * random_number(k, 8));
    const Vec3d direction = random_vector(k, 0);
    if (norm2(direction) > 1 || norm2(direction) < 0.01) continue;
    // The grain moves inwards along a ray until it touches another one.
    double reach = centres.empty() ? 0 : -1;
    const Vec3d n = (1 / norm(direction)) * direction;
    for (std::size_t j = 0; j < centres.size(); ++j) {
      const double along = dot(centres[j], n), side2 = norm2(centres[j]) - along * along, sum = radius + radii[j];
      if (side2 < sum * sum) reach = std::max(reach, along + std::sqrt(sum * sum - side2));
    }
    if (reach < 0) continue;
    centres.push_back(reach * n);
    radii.push_back(radius);
  }
  return bonded(centres, radii, {0.1, AbsoluteBondRadius{0.005}});
}

/// Growth of the energy of a slightly disturbed rock in the engine; its bonds cannot break.
double growth(const RockTemplate& shape, double damping, double dt, Precision precision, int steps) {
  Scene scene = plain_scene(dt);
  scene.materials[0].shear_modulus = 1;  // particles that are not bonded may overlap
  scene.bonds = paper_bonds();
  scene.bonds->damping = damping;
  scene.bonds->tensile_strength = scene.bonds->shear_strength = 1e30;
  std::vector<NewRock> rocks{as_rock(shape)};
  for (NewParticle& p : rocks[0].particles) {
    p.velocity = 1e-3 * random_vector(p.id, 20);
    p.angular_velocity = 0.1 * random_vector(p.id, 30);
  }
  const auto dem = make_cpu_dem(scene, precision, 1);
  dem->insert(rocks);
  const double begin = dem->energy().kinetic;
  std::int64_t step = 0;
  double energy = begin;
  while (step < steps && std::isfinite(energy) && energy < 1e6 * begin) {
    run(*dem, dt, step, 50);
    const EnergyTerms e = dem->energy();
    energy = e.kinetic + e.bond_elastic;
  }
  return std::isfinite(energy) ? energy / begin : 1e300;
}

BondParameters bonds_with(double damping) {
  BondParameters bonds = paper_bonds();
  bonds.damping = damping;
  return bonds;
}

}  // namespace

TEST_CASE("H1 H2 the engine is stable below the guard's limit and unstable above it, whatever the damping", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const double damping = GENERATE(0.0, 0.05, 0.2, 0.5);
  const RockTemplate rock = mono_rock();
  const double limit = critical_step(rock, bonds_with(damping), {});
  INFO(rock.centres.size() << " particles, damping " << damping << ": limit " << limit * 1e6 << " us");
  for (const double factor : {0.9, 0.99}) CHECK(growth(rock, damping, factor * limit, precision, 4000) < 1.5);
  for (const double factor : {1.01, 1.1, 2.0}) CHECK(growth(rock, damping, factor * limit, precision, 4000) > 1e6);
}

TEST_CASE("H2 damping lowers the limit to what was measured on another rock", "[hard]") {
  // 25 mm grains, Rb 5 mm: 7.0-7.5, 5.5-6, 3-4 and 1-2 us at 0, 5, 20 and 50 % of damping.
  const auto [damping, low, high] =
      GENERATE(table<double, double, double>({{0.0, 6.8, 8.0}, {0.05, 5.3, 6.3}, {0.2, 3.0, 4.2}, {0.5, 1.0, 2.1}}));
  const double limit = 1e6 * critical_step(mono_rock(), bonds_with(damping), {});
  INFO(damping << ": " << limit << " us");
  CHECK(limit > low);
  CHECK(limit < high);
}

TEST_CASE("H3 H4 slivers and mixed grains set the limit, in the engine too", "[hard]") {
  const Precision precision = GENERATE(Precision::double_, Precision::mixed);
  const bool sliver = GENERATE(true, false);
  const double damping = GENERATE(0.0, 0.2);
  const RockTemplate rock = sliver ? star() : graded_rock();
  const double limit = critical_step(rock, bonds_with(damping), {});
  const double quick = gershgorin_step(rock, bonds_with(damping), {});
  INFO((sliver ? "star" : "graded") << ", " << rock.bonds.size() << " bonds, damping " << damping << ": limit "
                                    << limit * 1e6 << " us, Gershgorin " << quick * 1e6 << " us");
  CHECK(limit < 3e-6);
  CHECK(quick <= limit);
  CHECK(growth(rock, damping, 0.98 * limit, precision, 2000) < 2);
  CHECK(growth(rock, damping, 1.02 * limit, precision, 6000) > 1e6);
}

namespace {

/// A close packing with twelve contacts of a sphere inside it, in a box that it fills.
/// @param overlap  of neighbours over the radius
std::vector<NewRock> close_packing(double radius, double overlap, Scene& scene) {
  const int n = 4;
  const double edge = std::sqrt(2.0) * radius * (2 - overlap);  // of the cube of a face-centred lattice
  std::vector<NewRock> spheres;
  for (int k = 0; k < 2 * n; ++k)
    for (int j = 0; j < 2 * n; ++j)
      for (int i = 0; i < 2 * n; ++i) {
        if ((i + j + k) % 2 != 0) continue;
        const auto id = static_cast<ParticleId>(spheres.size());
        const Vec3d centre = 0.5 * edge * Vec3d{i - n + 0.5, j - n + 0.5, k - n + 0.5};
        spheres.push_back(sphere(id, centre, 1e-3 * random_vector(id, 0), radius, 2600));
      }
  const double half = 0.5 * edge * (n - 0.5) + (1 - 0.5 * overlap) * radius;
  scene.walls = box({half, half, half});
  return spheres;
}

}  // namespace

TEST_CASE("H1 the densest bed keeps its energy balance at the step that the program chooses, or is stopped", "[hard]") {
  // A close packing with overlaps of 1 to 20 % of the radius: twelve contacts each, twice as many as the choice of the
  // step assumes. The guard knows the real stiffness and stops the run where the step is above the limit: from 5 % on,
  // or from 10 % on with e = 0.2, whose step is shorter.
  const double overlap = GENERATE(0.01, 0.05, 0.1, 0.2), restitution = GENERATE(0.2, 0.9, 1.0);
  const double radius = 0.01;
  Scene scene = plain_scene(0);
  scene.pairs.assign(4, {0.5, restitution, 0});
  scene.dt = 0.7 * loose_critical_step(radius, 2600, bed_contacts(scene));
  const std::vector<NewRock> spheres = close_packing(radius, overlap, scene);
  const auto dem = make_cpu_dem(scene, Precision::double_, 1);
  dem->insert(spheres);
  Ledger ledger({.step = scene.limits});
  std::optional<std::string> verdict;
  double stored = 0, maximum = 0, worst = 0;
  for (int k = 0; k < 20 && !verdict; ++k) {
    ledger.open(dem->energy());
    dem->advance({50 * k, 50, scene.dt}, {});
    const EnergyTerms e = dem->energy();
    stored = e.exchanged;
    maximum = std::max(maximum, e.kinetic + e.contact_elastic);
    worst = std::max(worst, std::abs(e.residual()));
    verdict = ledger.close((k + 1) * 50 * scene.dt, e, dem->extremes());
  }
  INFO("overlap " << overlap << ", restitution " << restitution << ": largest energy " << maximum / stored
                  << ", residual " << worst / stored << " of what was stored; " << verdict.value_or("no verdict"));
  if (verdict) {
    CHECK(overlap >= (restitution == 0.2 ? 0.1 : 0.05));
  } else {
    CHECK(maximum < 1.02 * stored);
    CHECK(worst < 0.05 * stored);
  }
}

TEST_CASE("H1 the guard knows the stability limit of what is pressed", "[hard]") {
  // Stiffness goes with the number of contacts and the root of the overlap: four times that of six contacts at 5 %.
  const double radius = 0.01, overlap = 0.2;
  Scene scene = plain_scene(0);
  scene.pairs.assign(4, {0.5, 1, 0});
  scene.dt = 0.6 * loose_critical_step(radius, 2600, bed_contacts(scene));
  const std::vector<NewRock> spheres = close_packing(radius, overlap, scene);
  const auto dem = make_cpu_dem(scene, Precision::double_, 1);
  dem->insert(spheres);
  dem->advance({0, 1, scene.dt}, {});
  const Extremes x = dem->extremes();
  CHECK(x.contact_step == Approx(2 * 0.6).epsilon(0.02));
  CHECK(x.crowd == 12);
  Ledger ledger({.step = scene.limits});
  ledger.open(dem->energy());
  const std::optional<std::string> verdict = ledger.close(scene.dt, dem->energy(), x);
  REQUIRE(verdict);
  CHECK_THAT(*verdict, Catch::Matchers::Contains("times the stability limit of the 12 contacts"));
}
