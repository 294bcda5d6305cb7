// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/linear_rock.hpp"

#include "core/laws/bond/springs.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

using Row12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

/// A spring and its damper along one relative motion of two particles.
struct SpringDamper {
  double stiffness, damping;
};

/// The springs of a bond (core/laws/bond/springs.hpp), each damped by c = 2 xi sqrt(k m_eff), m_eff = the pair's
/// reduced mass or moment of inertia.
struct DampedBond {
  SpringDamper normal, shear, twist, bending;
};

DampedBond damped_bond(const BondParameters& p, const TemplateBond& bond, double reduced_mass, double reduced_inertia) {
  const auto k = bond_springs(stiffness_per_area(p.normal_stiffness, p.normal_modulus, bond.length),
                              stiffness_per_area(p.shear_stiffness, p.shear_modulus, bond.length), bond.radius);
  const auto damped = [&](double spring, double m) {
    return SpringDamper{spring, 2 * p.damping * std::sqrt(spring * m)};
  };
  return {damped(k.normal, reduced_mass), damped(k.shear, reduced_mass), damped(k.twist, reduced_inertia),
          damped(k.bending, reduced_inertia)};
}

Row12 row(const Vec3d& xi, const Vec3d& rotation_i, const Vec3d& xj, const Vec3d& rotation_j) {
  Row12 r;
  r << xi.x, xi.y, xi.z, rotation_i.x, rotation_i.y, rotation_i.z, xj.x, xj.y, xj.z, rotation_j.x, rotation_j.y,
      rotation_j.z;
  return r;
}

struct Element {
  Matrix12 stiffness = Matrix12::Zero(), damping = Matrix12::Zero();
  void add(const Row12& motion, const SpringDamper& s) {
    stiffness += s.stiffness * motion * motion.transpose();
    damping += s.damping * motion * motion.transpose();
  }
};

/// Elongation u = x_j - x_i - (rotation_i x n) L_i - (rotation_j x n) L_j, with L_i + L_j = L0 so that angular momentum
/// is conserved; relative rotation theta = rotation_j - rotation_i.
Element bond_element(const RockTemplate& rock, const TemplateBond& bond, const DampedBond& springs) {
  const Vec3d zero{0, 0, 0}, d = rock.centres[bond.j] - rock.centres[bond.i];
  const Vec3d n = (1 / norm(d)) * d;
  const Vec3d helper = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d across = cross(n, helper), t1 = (1 / norm(across)) * across, t2 = cross(n, t1);
  const double arm_i = (bond.length + rock.radii[bond.i] - rock.radii[bond.j]) / 2, arm_j = bond.length - arm_i;
  Element element;
  element.add(row(-n, zero, n, zero), springs.normal);
  element.add(row(zero, -n, zero, n), springs.twist);
  for (const Vec3d& t : {t1, t2}) {
    const Vec3d lever = cross(n, t);  // t . (rotation x n) = rotation . (n x t)
    element.add(row(-t, -arm_i * lever, t, -arm_j * lever), springs.shear);
    element.add(row(zero, -t, zero, t), springs.bending);
  }
  return element;
}

/// Diagonal part that the bed adds to one particle, [0] for translations, [1] for rotations.
std::array<SpringDamper, 2> bed_springs(const BedContacts& bed, double radius, double mass) {
  constexpr double counterphase = 2;
  const double kn = bed.normal_stiffness * radius, kt = bed.tangential_stiffness * radius;
  const double cn = 2 * bed.normal_damping * std::sqrt(kn * mass / 2);
  const double ct = 2 * bed.tangential_damping * std::sqrt(kt * mass / 2);
  const double n = counterphase * bed.number;
  const double r2 = radius * radius;
  return {SpringDamper{n * (kn + 2 * kt) / 3, n * (cn + 2 * ct) / 3},
          SpringDamper{n * 2 * kt * r2 / 3, n * 2 * ct * r2 / 3}};
}

}  // namespace

LinearRock linearise(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed) {
  const Eigen::Index particles = static_cast<Eigen::Index>(rock.centres.size());
  std::vector<double> mass(particles), inertia(particles);
  std::vector<Eigen::Triplet<double>> stiffness, damping;
  LinearRock linear;
  linear.inverse_root_mass.resize(6 * particles);
  for (Eigen::Index p = 0; p < particles; ++p) {
    const double r = rock.radii[p];
    mass[p] = rock.particle_density * 4 * std::numbers::pi / 3 * r * r * r;
    inertia[p] = 0.4 * mass[p] * r * r;
    const auto springs = bed_springs(bed, r, mass[p]);
    for (int k = 0; k < 6; ++k) {
      const double m = k < 3 ? mass[p] : inertia[p];
      linear.inverse_root_mass[6 * p + k] = 1 / std::sqrt(m);
      stiffness.emplace_back(6 * p + k, 6 * p + k, springs[k / 3].stiffness / m);
      damping.emplace_back(6 * p + k, 6 * p + k, springs[k / 3].damping / m);
    }
  }
  for (const TemplateBond& bond : rock.bonds) {
    const Index i = bond.i, j = bond.j;
    const auto reduced = [&](const std::vector<double>& m) { return m[i] * m[j] / (m[i] + m[j]); };
    const Element e = bond_element(rock, bond, damped_bond(bonds, bond, reduced(mass), reduced(inertia)));
    const auto row = [&](int k) { return k < 6 ? 6 * i + k : 6 * j + k - 6; };
    for (int a = 0; a < 12; ++a) {
      for (int b = 0; b < 12; ++b) {
        const double scale = linear.inverse_root_mass[row(a)] * linear.inverse_root_mass[row(b)];
        stiffness.emplace_back(row(a), row(b), scale * e.stiffness(a, b));
        damping.emplace_back(row(a), row(b), scale * e.damping(a, b));
      }
    }
  }
  for (auto* m : {&linear.stiffness, &linear.damping}) m->resize(6 * particles, 6 * particles);
  linear.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  linear.damping.setFromTriplets(damping.begin(), damping.end());
  return linear;
}

}  // namespace gyro
