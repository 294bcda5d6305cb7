// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/rock_springs.hpp"

#include "core/laws/bond/springs.hpp"

#include <cmath>
#include <numbers>

namespace gyro {

Inertia inertia_of(double radius, double density) {
  const double mass = density * 4 * std::numbers::pi / 3 * radius * radius * radius;
  return {mass, 0.4 * mass * radius * radius};
}

DampedBond damped_bond(const BondParameters& p, const RockTemplate& rock, const TemplateBond& bond) {
  const Inertia i = inertia_of(rock.radii[bond.i], rock.particle_density);
  const Inertia j = inertia_of(rock.radii[bond.j], rock.particle_density);
  const auto k = bond_springs(stiffness_per_area(p.normal_stiffness, p.normal_modulus, bond.length),
                              stiffness_per_area(p.shear_stiffness, p.shear_modulus, bond.length), bond.radius);
  const auto reduced = [](double a, double b) { return a * b / (a + b); };
  const double mass = reduced(i.mass, j.mass), moment = reduced(i.moment, j.moment);
  const auto damped = [&](double spring, double m) {
    return SpringDamper{spring, 2 * p.damping * std::sqrt(spring * m)};
  };
  return {damped(k.normal, mass), damped(k.shear, mass), damped(k.twist, moment), damped(k.bending, moment)};
}

BedSprings scaled_bed(const BedContacts& bed, double radius, const Inertia& inertia) {
  constexpr double counterphase = 2;
  const double kn = bed.normal_stiffness * radius, kt = bed.tangential_stiffness * radius;
  const double cn = 2 * bed.normal_damping * std::sqrt(kn * inertia.mass / 2);
  const double ct = 2 * bed.tangential_damping * std::sqrt(kt * inertia.mass / 2);
  const double n = counterphase * bed.number;
  const double r2 = radius * radius;
  return {SpringDamper{n * (kn + 2 * kt) / 3 / inertia.mass, n * (cn + 2 * ct) / 3 / inertia.mass},
          SpringDamper{n * 2 * kt * r2 / 3 / inertia.moment, n * 2 * ct * r2 / 3 / inertia.moment}};
}

}  // namespace gyro
