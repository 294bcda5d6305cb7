// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/linear_rock.hpp"

#include "core/rocks/rock_springs.hpp"

#include <cmath>

namespace gyro {
namespace {

using Row12 = Eigen::Matrix<double, 12, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

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

Element bond_element(const BondFrame& frame, const DampedBond& springs) {
  const Vec3d zero{0, 0, 0}, n = frame.n;
  const Vec3d helper = std::abs(n.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d across = cross(n, helper), t1 = (1 / norm(across)) * across, t2 = cross(n, t1);
  Element element;
  element.add(row(-n, zero, n, zero), springs.normal);
  element.add(row(zero, -n, zero, n), springs.twist);
  for (const Vec3d& t : {t1, t2}) {
    const Vec3d lever = cross(n, t);  // t . (rotation x n) = rotation . (n x t)
    element.add(row(-t, -frame.arm_i * lever, t, -frame.arm_j * lever), springs.shear);
    element.add(row(zero, -t, zero, t), springs.bending);
  }
  return element;
}

}  // namespace

LinearRock linearise(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed) {
  const Eigen::Index particles = static_cast<Eigen::Index>(rock.centres.size());
  std::vector<Eigen::Triplet<double>> stiffness, damping;
  LinearRock linear;
  linear.inverse_root_mass.resize(6 * particles);
  for (Eigen::Index p = 0; p < particles; ++p) {
    const Inertia inertia = inertia_of(rock.radii[p], rock.particle_density);
    const InverseRoot scale(inertia);
    const BedSprings springs = scaled_bed(bed, rock.radii[p], inertia);
    for (int k = 0; k < 6; ++k) {
      const SpringDamper& spring = k < 3 ? springs.translation : springs.rotation;
      linear.inverse_root_mass[6 * p + k] = k < 3 ? scale.mass : scale.moment;
      stiffness.emplace_back(6 * p + k, 6 * p + k, spring.stiffness);
      damping.emplace_back(6 * p + k, 6 * p + k, spring.damping);
    }
  }
  for (const TemplateBond& bond : rock.bonds) {
    const Index i = bond.i, j = bond.j;
    const Element e = bond_element(bond_frame(rock, bond), damped_bond(bonds, rock, bond));
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
