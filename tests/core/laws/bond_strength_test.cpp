// SPDX-License-Identifier: GPL-3.0-or-later
// Stiffness and strength of a bond: d 25 mm, Rb 5 mm, kn 1.67e12 and ks 6.67e11 Pa/m, 36 and 24 MPa.
// Beam formulas of Potyondy & Cundall (2004); the numbers are their values.
#include "tests/catch.hpp"
#include "tests/core/laws/bonds.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

Ends stretched(double u) {
  Ends e;
  e.j.x += u;
  return e;
}
Ends sheared(double u) {
  Ends e;
  e.j.y += u;
  return e;
}
Ends bent(double angle) {
  Ends e;
  e.orientation_i = rotation_about({0, 1, 0}, -angle / 2);
  e.orientation_j = rotation_about({0, 1, 0}, angle / 2);
  return e;
}
Ends twisted(double angle) {
  Ends e;
  e.orientation_i = rotation_about({1, 0, 0}, -angle / 2);
  e.orientation_j = rotation_about({1, 0, 0}, angle / 2);
  return e;
}

}  // namespace

TEST_CASE("Stiffness of each mode of a bond", "[laws][bond]") {
  const double u = 1e-6, angle = 1e-4;
  CHECK(-load_of(stretched(u)).force.x / u == Approx(normal_rate).epsilon(1e-6));
  CHECK(-load_of(sheared(u)).force.y / u == Approx(shear_rate).epsilon(1e-6));
  CHECK(-load_of(bent(angle)).torque_j.y / angle == Approx(bend_rate).epsilon(1e-6));
  CHECK(-load_of(twisted(angle)).torque_j.x / angle == Approx(twist_rate).epsilon(1e-6));
  CHECK(load_of(stretched(u)).elastic == Approx(0.5 * normal_rate * u * u).epsilon(1e-6));
  CHECK(load_of(sheared(u)).elastic == Approx(0.5 * shear_rate * u * u).epsilon(1e-6));
  CHECK(load_of(bent(angle)).elastic == Approx(0.5 * bend_rate * angle * angle).epsilon(1e-6));
  CHECK(load_of(twisted(angle)).elastic == Approx(0.5 * twist_rate * angle * angle).epsilon(1e-6));
}

TEST_CASE("A sheared bond loads each end with half the couple", "[laws][bond]") {
  const BondLoad<double> load = load_of(sheared(1e-6));
  CHECK(load.torque_i.z == Approx(0.5 * shear_rate * 1e-6 * bond_length).epsilon(1e-6));
  CHECK(load.torque_j.z == Approx(0.5 * shear_rate * 1e-6 * bond_length).epsilon(1e-6));
  // The section is at 0.3 of the length: the nearer end has the shorter lever.
  const BondLoad<double> uneven = load_of(sheared(1e-6), paper_law(), 0.3);
  CHECK(uneven.torque_i.z / uneven.torque_j.z == Approx(0.3 / 0.7).epsilon(1e-9));
}

TEST_CASE("A bond fails at its strength in each mode", "[laws][bond]") {
  const BondLoad<double> tension = load_of(stretched(21.5569e-6));
  CHECK(tension.tension_ratio == Approx(1).epsilon(1e-5));
  CHECK(-tension.force.x == Approx(2827.433).epsilon(1e-5));

  const BondLoad<double> shear = load_of(sheared(35.9820e-6));
  CHECK(shear.shear_ratio == Approx(1).epsilon(1e-5));
  CHECK(norm(shear.force - shear.force.x * Vec3d{1, 0, 0}) == Approx(1884.956).epsilon(1e-5));

  const BondLoad<double> bend = load_of(bent(4.311377e-3));
  CHECK(bend.tension_ratio == Approx(1).epsilon(2e-6));
  CHECK(norm(bend.torque_j) == Approx(bend_rate * std::sin(4.311377e-3)).epsilon(1e-6));
  CHECK(bend.shear_ratio < 1e-9);

  const BondLoad<double> twist = load_of(twisted(7.196402e-3));
  CHECK(twist.shear_ratio == Approx(1).epsilon(3e-6));
  CHECK(norm(twist.torque_j) == Approx(twist_rate * std::sin(7.196402e-3)).epsilon(1e-6));
  CHECK(std::abs(twist.tension_ratio) < 1e-9);
}

TEST_CASE("Bonds fail on a straight line between two loads, and compression strengthens them", "[laws][bond]") {
  const double share = GENERATE(0.1, 0.5, 0.9);
  Ends pulled = bent((1 - share) * 4.311377e-3);
  pulled.j.x += share * 21.5569e-6;
  const BondLoad<double> a = load_of(pulled);
  CHECK(a.tension_ratio == Approx(1).epsilon(1e-5));
  CHECK(-a.force.x / 2827.433 + norm(a.torque_j) / 3.534292 == Approx(1).epsilon(1e-5));

  Ends twisted_and_sheared = twisted((1 - share) * 7.196402e-3);
  twisted_and_sheared.j.y += share * 35.9820e-6;
  const BondLoad<double> b = load_of(twisted_and_sheared);
  CHECK(b.shear_ratio == Approx(1).epsilon(1e-5));

  Ends pressed = bent(4.311377e-3);
  pressed.j.x -= share * 21.5569e-6;
  CHECK(load_of(pressed).tension_ratio == Approx(1 - share).margin(1e-5));
}

TEST_CASE("The factor of a bond scales both strengths and nothing else", "[laws][bond]") {
  BondSection<double> strong = paper_section();
  strong.strength = 1.6;
  const BondStrain<double> strain = strain_of(strained(3, 3e-3));
  const BondLoad<double> a = PaperBond::load(paper_law(), paper_section(), strain, at_rest());
  const BondLoad<double> b = PaperBond::load(paper_law(), strong, strain, at_rest());
  CHECK(a.tension_ratio / b.tension_ratio == Approx(1.6));
  CHECK(a.shear_ratio / b.shear_ratio == Approx(1.6));
  CHECK(norm(a.force) == norm(b.force));
}

TEST_CASE("Stiffness given as a modulus falls with the length", "[laws][bond]") {
  BondConstants<double> law = paper_law();
  law.bond.normal_stiffness = law.bond.shear_stiffness = 0;
  law.bond.normal_modulus = 1.67e12 * bond_length;
  law.bond.shear_modulus = 6.67e11 * bond_length;
  const Ends ends = strained(5, 3e-3);
  const BondLoad<double> a = load_of(ends), b = load_of(ends, law);
  CHECK(distance(a.force, b.force) < 1e-12 * norm(a.force));
  CHECK(distance(a.torque_j, b.torque_j) < 1e-12 * norm(a.torque_j));

  BondSection<double> twice = paper_section();
  twice.length = 2 * bond_length;
  BondStrain<double> strain = strain_of(stretched(1e-6));
  strain.length += bond_length;
  CHECK(-PaperBond::load(law, twice, strain, at_rest()).force.x == Approx(0.5 * normal_rate * 1e-6).epsilon(1e-6));
}
