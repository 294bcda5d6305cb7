// SPDX-License-Identifier: GPL-3.0-or-later
// A bond that has failed while its ends are pressed together.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

/// Ends pressed together (stretch < 0), with shear and rotation.
Ends pressed(std::uint64_t k) {
  Ends e = strained(k, 2e-3);
  const Vec3d d = e.j - e.i;
  e.j = e.i + ((1 - 1e-3 * (1.1 + random_number(k, 60))) * bond_length / norm(d)) * d;
  return e;
}

}  // namespace

TEST_CASE("Failure in compression keeps the normal force", "[laws][bond]") {
  BondConstants<double> law = paper_law();
  law.bond.damping = GENERATE(0.0, 0.05);
  for (std::uint64_t k = 0; k < 20; ++k) {
    const BondStrain<double> strain = strain_of(pressed(k));
    const BondRates<double> rates{0.1 * random_vector(k, 20), random_vector(k, 23), random_vector(k, 26)};
    const Vec3d before = PaperBond::load(law, paper_section(), strain, rates).force;
    const Vec3d after = pressed_load(law, paper_section(), strain, rates).load.force;
    REQUIRE(dot(before, strain.normal) > 0);
    CHECK(dot(after, strain.normal) == Approx(dot(before, strain.normal)).epsilon(1e-12));
  }
}

TEST_CASE("A broken bond that is still pressed never pulls and stays within Coulomb's limit", "[laws][bond]") {
  BondConstants<double> law = paper_law();
  law.bond.damping = 0.05;
  int slipping = 0, pushing = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    const BondStrain<double> strain = strain_of(k % 2 ? pressed(k) : strained(k, 3e-3));
    const BondRates<double> rates{20.0 * random_vector(k, 20), random_vector(k, 23), random_vector(k, 26)};
    const PressedLoad<double> u = pressed_load(law, paper_section(), strain, rates);
    const double push = dot(u.load.force, strain.normal);
    const Vec3d friction = tangential(u.load.force, strain.normal);
    CHECK(push >= 0);
    if (strain.stretch >= 0) CHECK(norm(u.load.force) == 0);
    CHECK(norm(friction) <= law.friction * push * (1 + 1e-12) + 1e-9);
    if (u.keep < 1 && push > 0) CHECK(norm(friction) == Approx(law.friction * push).epsilon(1e-9));
    CHECK(u.keep >= 0);
    CHECK(u.keep <= 1);
    CHECK(u.load.damped >= 0);
    slipping += u.keep < 1;
    pushing += push > 0;
  }
  CHECK(slipping > 20);
  CHECK(slipping < 180);
  CHECK(pushing > 50);
}

TEST_CASE("Slip of a broken pressed bond dissipates exactly the energy that it stored", "[laws][bond]") {
  for (std::uint64_t k = 0; k < 50; ++k) {
    const BondStrain<double> strain = strain_of(pressed(k));
    const PressedLoad<double> u = pressed_load(paper_law(), paper_section(), strain, at_rest());
    // Energy of the intact bond, whose spring is the same except for the cosine of the shear angle.
    const double before = 0.5 * normal_rate * strain.stretch * strain.stretch +
                          0.5 * shear_rate * bond_length * bond_length * norm2(strain.shear);
    CHECK(u.load.elastic + u.slip_work == Approx(before).epsilon(1e-5));
    CHECK(u.slip_work >= 0);
  }
}

TEST_CASE("Sliding dissipates friction times path, whatever the step", "[laws][bond]") {
  // Pressed by 10 um and drawn sideways by 30 um, then pulled off: the work of the shear force closes.
  const int steps = GENERATE(100, 1000);
  BondConstants<double> law = paper_law();
  const double press = 1e-5, way = 3e-5;
  const double speed = 1, dt = way / steps / speed, push = normal_rate * press;
  law.dt = dt;
  BondShape<double> shape = paper_shape();
  double work = 0, slipped = 0;
  Vec3d before{0, 0, 0};
  for (int k = 1; k <= steps; ++k) {
    const BondEnds<double> ends{{bond_length - press, way * k / steps, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
    const BondStrain<double> strain = bond_strain(shape, ends);
    const PressedLoad<double> u = pressed_load(law, paper_section(), strain, {{0, speed, 0}, {0, 0, 0}, {0, 0, 0}});
    const Vec3d shear = tangential(u.load.force, strain.normal);
    work -= 0.5 * dt * speed * (before.y + shear.y);
    slipped += u.slip_work;
    shape.axis = slipped_axis(strain, u.keep);
    before = shear;
    if (k == steps)
      CHECK(work ==
            Approx(slipped + u.load.elastic - 0.5 * normal_rate * strain.stretch * strain.stretch).epsilon(2e-3));
  }
  const double stick = 0.5 * push / shear_rate;  // displacement before slip
  CHECK(slipped == Approx(0.5 * push * (way - stick)).epsilon(0.01));

  const BondEnds<double> apart{{bond_length + 1e-9, way, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
  const PressedLoad<double> off = pressed_load(law, paper_section(), bond_strain(shape, apart), at_rest());
  CHECK(off.slip_work == Approx(0.5 * 0.5 * push * stick).epsilon(0.01));
  CHECK(off.load.elastic == 0);
}

TEST_CASE("Ends that slide past each other without pressure dissipate no energy", "[laws][bond]") {
  // At 1.1 L0, as where spheres were packed with an overlap. The spring at L0 would book -0.09 of `scale` a step.
  BondConstants<double> law = paper_law();
  const double speed = 1, dt = 1e-6, length = 1.1 * bond_length, scale = shear_rate * dt * dt * speed * speed;
  law.dt = dt;
  BondShape<double> shape = paper_shape();
  for (int k = 1; k <= 100; ++k) {
    const BondEnds<double> ends{{length, speed * dt * k, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}};
    const BondStrain<double> strain = bond_strain(shape, ends);
    const PressedLoad<double> u = pressed_load(law, paper_section(), strain, {{0, speed, 0}, {0, 0, 0}, {0, 0, 0}});
    CHECK(norm(u.load.force) == 0);
    CHECK(std::abs(u.slip_work) < 1e-4 * scale);
    shape.axis = slipped_axis(strain, u.keep);
  }
}

TEST_CASE("The slipped axis has the shear that remains after slip", "[laws][bond]") {
  for (std::uint64_t k = 0; k < 50; ++k) {
    const double arm = 0.5 + 0.3 * random_number(k, 70), keep = 0.5 + 0.5 * random_number(k, 71);
    const Ends ends = pressed(k);
    BondShape<double> shape = paper_shape(arm);
    const BondStrain<double> before = bond_strain(shape, ends.relative());
    shape.axis = slipped_axis(before, keep);
    CHECK(norm(shape.axis) == Approx(1).epsilon(1e-14));
    const BondStrain<double> after = strain_about(shape.axis, shape.length, ends.relative());
    // The new axis is unit: the shear it shows differs from the wish by |gamma|^2/2.
    CHECK(distance(after.shear, keep * before.shear) < 0.5 * norm2(before.shear) * norm(before.shear) + 1e-15);
    CHECK(after.stretch == before.stretch);
    CHECK(after.twist == before.twist);
  }
}
