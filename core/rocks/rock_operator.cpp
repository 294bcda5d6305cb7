// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/rock_operator.hpp"

#include "core/rocks/mode_step.hpp"

#include <algorithm>

namespace gyro {
namespace {

struct Motion {
  Vec3d shift, turn;
};

Motion motion_of(const Eigen::VectorXd& v, std::size_t particle) {
  const double* at = v.data() + 6 * particle;
  return {{at[0], at[1], at[2]}, {at[3], at[4], at[5]}};
}

Motion operator*(const InverseRoot& scale, const Motion& m) {
  return {scale.mass * m.shift, scale.moment * m.turn};
}

void add(Eigen::VectorXd& v, std::size_t particle, const Motion& m) {
  double* at = v.data() + 6 * particle;
  at[0] += m.shift.x, at[1] += m.shift.y, at[2] += m.shift.z;
  at[3] += m.turn.x, at[4] += m.turn.y, at[5] += m.turn.z;
}

/// Elongation and relative rotation of a bond (rock_springs.hpp).
Motion strain(const BondFrame& bond, const Motion& i, const Motion& j) {
  return {j.shift - i.shift - cross(bond.arm_i * i.turn + bond.arm_j * j.turn, bond.n), j.turn - i.turn};
}

}  // namespace

RockOperator::RockOperator(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed)
    : rock_(rock), bonds_(bonds), bed_(bed) {
  scales_.reserve(rock.radii.size());
  for (const double r : rock.radii) scales_.emplace_back(inertia_of(r, rock.particle_density));
}

BedSprings RockOperator::bed_of(std::size_t particle) const {
  const double radius = rock_.radii[particle];
  return scaled_bed(bed_, radius, inertia_of(radius, rock_.particle_density));
}

void RockOperator::set_step(double dt) {
  bond_factors_.clear();
  bond_factors_.reserve(rock_.bonds.size());
  const auto factor = [dt](const SpringDamper& s) { return dt * dt * s.stiffness + 2 * dt * s.damping; };
  for (const TemplateBond& bond : rock_.bonds) {
    const DampedBond s = damped_bond(bonds_, rock_, bond);
    bond_factors_.push_back({factor(s.normal), factor(s.shear), factor(s.twist), factor(s.bending)});
  }
  bed_factors_.clear();
  bed_factors_.reserve(scales_.size());
  const auto capped = [&](const SpringDamper& s) {
    return dt * dt * s.stiffness + 2 * std::min(dt * s.damping, bed_.damping_cap);
  };
  for (std::size_t p = 0; p < scales_.size(); ++p) {
    const BedSprings s = bed_of(p);
    bed_factors_.push_back({capped(s.translation), capped(s.rotation)});
  }
}

void RockOperator::apply(const Eigen::VectorXd& x, Eigen::VectorXd& result) const {
  for (std::size_t p = 0; p < scales_.size(); ++p) {
    for (std::size_t k = 6 * p; k < 6 * p + 3; ++k) {
      result[k] = bed_factors_[p].translation * x[k];
      result[k + 3] = bed_factors_[p].rotation * x[k + 3];
    }
  }
  for (std::size_t b = 0; b < bond_factors_.size(); ++b) {
    const TemplateBond& bond = rock_.bonds[b];
    const BondFactors& e = bond_factors_[b];
    const InverseRoot &si = scales_[bond.i], &sj = scales_[bond.j];
    const BondFrame frame = bond_frame(rock_, bond);
    const Motion s = strain(frame, si * motion_of(x, bond.i), sj * motion_of(x, bond.j));
    const Vec3d& n = frame.n;
    const Vec3d force = e.shear * s.shift + ((e.normal - e.shear) * dot(n, s.shift)) * n;
    const Vec3d moment = e.bending * s.turn + ((e.twist - e.bending) * dot(n, s.turn)) * n;
    const Vec3d lever = cross(n, force);  // (rotation x n) . force = rotation . (n x force)
    add(result, bond.i, si * Motion{-force, -frame.arm_i * lever - moment});
    add(result, bond.j, sj * Motion{force, moment - frame.arm_j * lever});
  }
}

double RockOperator::step_of_mode(const Eigen::VectorXd& v) const {
  double a = 0, b = 0;
  const auto strained = [&](const SpringDamper& s, double square) {
    a += s.stiffness * square;
    b += s.damping * square;
  };
  for (const TemplateBond& bond : rock_.bonds) {
    const BondFrame frame = bond_frame(rock_, bond);
    const Motion s = strain(frame, scales_[bond.i] * motion_of(v, bond.i), scales_[bond.j] * motion_of(v, bond.j));
    const DampedBond springs = damped_bond(bonds_, rock_, bond);
    const double stretch = dot(frame.n, s.shift), twist = dot(frame.n, s.turn);
    strained(springs.normal, stretch * stretch);
    strained(springs.shear, norm2(s.shift - stretch * frame.n));
    strained(springs.twist, twist * twist);
    strained(springs.bending, norm2(s.turn - twist * frame.n));
  }
  for (std::size_t p = 0; p < scales_.size(); ++p) {
    const Motion m = motion_of(v, p);
    const BedSprings bed = bed_of(p);
    a += bed.translation.stiffness * norm2(m.shift) + bed.rotation.stiffness * norm2(m.turn);
  }
  return capped_step(a, b, bed_.damping_cap, [&](double dt) {
    BedDamping sum;
    for (std::size_t p = 0; p < scales_.size(); ++p) {
      const Motion m = motion_of(v, p);
      const BedSprings bed = bed_of(p);
      sum.add(norm2(m.shift), bed.translation.damping, dt, bed_.damping_cap);
      sum.add(norm2(m.turn), bed.rotation.damping, dt, bed_.damping_cap);
    }
    return sum;
  });
}

}  // namespace gyro
