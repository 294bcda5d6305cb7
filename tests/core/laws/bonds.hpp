// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/fixtures/random.hpp"
#include "core/laws/bond/bond_load.hpp"

#include <cmath>

// A bond for the tests of its law: two particles of 25 mm, a radius of 5 mm, the paper's stiffness.

namespace gyro::test {

using namespace fixtures;

inline constexpr double bond_length = 0.025, bond_radius = 0.005;
inline constexpr double normal_rate = 1.311615e8;  ///< kn A [N/m]
inline constexpr double shear_rate = 5.238606e7;   ///< ks A [N/m]
inline constexpr double bend_rate = 819.759;       ///< kn I [N m]
inline constexpr double twist_rate = 654.826;      ///< ks J [N m]

/// Most tests use the law with constant strengths.
using PaperBond = BondLaw<ConstantStrength>;

inline BondConstants<double> paper_law() {
  return {{1.67e12, 6.67e11, 36e6, 24e6}, 0.5, 1e-6};
}

inline double sphere_mass() {
  return 2600 * 4.0 / 3 * M_PI * std::pow(bond_length / 2, 3);
}
inline double sphere_inertia() {
  return 0.4 * sphere_mass() * std::pow(bond_length / 2, 2);
}

inline BondSection<double> paper_section(double arm = 0.5) {
  return {bond_radius, 1, std::sqrt(sphere_mass() / 2), std::sqrt(sphere_inertia() / 2), arm, bond_length};
}

inline BondRates<double> at_rest() {
  return {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
}

inline Quatd random_orientation(std::uint64_t thing, std::uint32_t draw) {
  const Vec3d v = random_vector(thing, draw);
  return normalised(Quatd{random_number(thing, draw + 3), v.x, v.y, v.z});
}

/// Two ends of a bond.
struct Ends {
  Vec3d i{0, 0, 0}, j{bond_length, 0, 0};
  Quatd orientation_i{1, 0, 0, 0}, orientation_j{1, 0, 0, 0};

  BondEnds<double> relative() const { return {j - i, orientation_i, orientation_j}; }
};

inline BondShape<double> paper_shape(double arm = 0.5) {
  return {{1, 0, 0}, bond_length, arm};
}

inline BondStrain<double> strain_of(const Ends& ends, double arm = 0.5) {
  return bond_strain(paper_shape(arm), ends.relative());
}
inline BondLoad<double> load_of(const Ends& ends, const BondConstants<double>& law = paper_law(), double arm = 0.5) {
  return PaperBond::load(law, paper_section(arm), strain_of(ends, arm), at_rest());
}

/// Ends at any position and orientation, with stretch, shear and relative rotation of size `strain`.
inline Ends strained(std::uint64_t thing, double strain) {
  Ends e;
  const Quatd all = random_orientation(thing, 0);
  e.i = random_vector(thing, 4);
  const Vec3d off = strain * bond_length * random_vector(thing, 7);
  e.j = e.i + rotate(all, Vec3d{bond_length, 0, 0} + Vec3d{0.2 * off.x, off.y, off.z});
  e.orientation_i = rotation_by(strain * random_vector(thing, 10)) * all;
  e.orientation_j = rotation_by(strain * random_vector(thing, 13)) * all;
  return e;
}

inline double distance(const Vec3d& a, const Vec3d& b) {
  return norm(a - b);
}

}  // namespace gyro::test
