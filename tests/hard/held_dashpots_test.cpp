// SPDX-License-Identifier: GPL-3.0-or-later
// H41: two bonded particles, each pinched between two plates, whose bond vibrates once in two steps of the contacts.
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/laws/contact/dashpots.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr double radius = 0.04, density = 2600, hold = 62.5e-6, press_time = 0.04;  // [m], [kg/m3], [s], [s]

/// Stable step of a pair of spheres on one bond, in tension or in shear with the rotation that goes with it [s].
double stable_step(const BondParameters& bonds, double bond_radius) {
  const double area = std::numbers::pi * bond_radius * bond_radius;
  const double mass = density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  const double inertia = 0.4 * mass * radius * radius;
  const double tension = 2 * bonds.normal_stiffness * area / mass;
  const double shear = bonds.shear_stiffness * area * (2 / mass + 2 * radius * radius / inertia);
  const double damped = std::sqrt(1 + bonds.damping * bonds.damping) - bonds.damping;
  return 2 / std::sqrt(std::max(tension, shear)) * damped;
}

/// The pair across the gap of two plates, of which one closes by up to a fifth of the radius and opens again.
Stage pinched_pair(const BondParameters& bonds, double bond_radius) {
  Scene s = bonded_scene(hold, bonds, {0.7, 0.2, 0.001});
  s.gravity = {0, 0, 0};
  s.substeps = static_cast<int>(std::ceil(hold / (0.7 * stable_step(bonds, bond_radius))));
  s.walls = {{"fixed", PlaneShape{{-radius, 0, 0}, {1, 0, 0}}, Fixed{}, 1},
             {"moving", PlaneShape{{radius, 0, 0}, {-1, 0, 0}}, CircularMotion{0.19 * radius, press_time}, 1}};
  NewRock pair = chain(0, 1, {2 * radius, radius, density});
  pair.bonds[0].radius = bond_radius;
  pair.bonds[0].strength = 1e6;
  for (int k = 0; k < 2; ++k) pair.particles[static_cast<std::size_t>(k)].position = {0, (2 * k - 1) * radius, 0};
  Stage stage(s, Precision::double_);
  stage.insert({pair});
  return stage;
}

/// Largest kinetic energy over the largest work of the plates.
double largest_motion(Stage& stage) {
  double kinetic = 0, work = 0;
  while (stage.time() < press_time && std::isfinite(kinetic)) {
    stage.advance(8);
    const EnergyTerms energy = stage.dem().energy();
    kinetic = std::max(kinetic, energy.kinetic);
    work = std::max(work, std::abs(energy.wall_work));
  }
  return kinetic / work;
}

}  // namespace

TEST_CASE("H41 held contacts do not feed the vibration of a pinched pair, whatever the radius of its bond") {
  BondParameters bonds = paper_bonds();
  bonds.damping = 0.05;
  for (double share = 0.12; share < 1; share += 0.01) {
    CAPTURE(share);
    Stage stage = pinched_pair(bonds, share * radius);
    CHECK(largest_motion(stage) < 2e-3);  // 7e-4 with steps of a quarter
  }
}

TEST_CASE("H41 the cap of held dashpots follows the damping of bonds") {
  CHECK(held_damping_cap(0.05) == Approx(0.3));
  CHECK(held_damping_cap(0.5) == 1);
  CHECK(held_damping_cap(0) == 0.02);
}
