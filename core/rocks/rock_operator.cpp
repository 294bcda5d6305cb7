// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/rock_operator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Motion {
  Vec3d shift, turn;
};

Motion motion_of(const Eigen::VectorXd& v, Index particle, double translation, double rotation) {
  const double* at = v.data() + 6 * static_cast<Eigen::Index>(particle);
  return {{translation * at[0], translation * at[1], translation * at[2]},
          {rotation * at[3], rotation * at[4], rotation * at[5]}};
}

void add(Eigen::VectorXd& v, Index particle, const Vec3d& shift, const Vec3d& turn) {
  double* at = v.data() + 6 * static_cast<Eigen::Index>(particle);
  at[0] += shift.x, at[1] += shift.y, at[2] += shift.z;
  at[3] += turn.x, at[4] += turn.y, at[5] += turn.z;
}

/// Elongation and relative rotation of a bond (rock_springs.hpp).
Motion strain(const BondFrame& bond, const Motion& i, const Motion& j) {
  return {j.shift - i.shift - cross(bond.arm_i * i.turn + bond.arm_j * j.turn, bond.n), j.turn - i.turn};
}

/// Smallest dt > 0 with dt^2 a + 2 dt b = rest.
double step_of(double a, double b, double rest) {
  const double sum = b + std::sqrt(b * b + a * rest);
  return sum > 0 ? rest / sum : infinite;
}

/// Dampers of the bed, each with the share (weight) of a motion that it has.
struct BedDamping {
  double uncapped = 0;  ///< sum of weight c over dampers below the cap
  double capped = 0;    ///< sum of weight over the others
  void add(double weight, double c, double dt, double cap) {
    if (dt * c > cap) {
      capped += weight;
    } else {
      uncapped += weight * c;
    }
  }
};

/// The dt > 0 with dt^2 a + 2 dt b + sum of weight min(2 dt c, 2 cap) = 4. Without the cap dt would be smaller. From
/// there dt grows while dampers reach the cap, and ends after finitely many rounds, because each has its own dt.
/// @param damping  BedDamping(dt)
template <class Damping>
double capped_step(double a, double b, double cap, const Damping& damping) {
  double dt = step_of(a, b + damping(0).uncapped, 4);
  for (bool grows = std::isfinite(dt) && std::isfinite(cap); grows;) {
    const BedDamping bed = damping(dt);
    const double next = step_of(a, b + bed.uncapped, 4 - 2 * cap * bed.capped);
    grows = next > dt && std::isfinite(next);
    dt = std::max(dt, next);
  }
  return dt;
}

/// One end of a bond.
struct End {
  double arm, translation, rotation;  ///< translation, rotation: 1/sqrt of mass and of moment of inertia
};

using Six = Eigen::Matrix<double, 6, 1>;

/// Row sums of the absolute values of a bond's matrix, of the rows of one end. Forces per shift are P s + N k, moments
/// per turn P b + N t, with N = n n^T and P = 1 - N, and a turn shifts the bond's middle by arm x n.
Six row_sums(const BondFrame& frame, const std::array<double, 4>& springs, const End& own, const End& other) {
  const auto [normal, shear, twist, bending] = springs;
  const auto sums = [](const Eigen::Matrix3d& m) -> Eigen::Vector3d { return m.cwiseAbs().rowwise().sum(); };
  const Eigen::Vector3d n(frame.n.x, frame.n.y, frame.n.z), size = n.cwiseAbs();
  const Eigen::Matrix3d along = n * n.transpose(), across = Eigen::Matrix3d::Identity() - along;
  const Eigen::Matrix3d turned = bending * across + twist * along;
  const Eigen::Vector3d crossed = shear * (Eigen::Vector3d::Constant(size.sum()) - size);
  Six sum;
  sum << own.translation * ((own.translation + other.translation) * sums(shear * across + normal * along) +
                            (own.arm * own.rotation + other.arm * other.rotation) * crossed),
      own.rotation * (own.arm * (own.translation + other.translation) * crossed +
                      own.rotation * sums(own.arm * own.arm * shear * across + turned) +
                      other.rotation * sums(own.arm * other.arm * shear * across - turned));
  return sum;
}

}  // namespace

RockOperator::RockOperator(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed)
    : rock_(rock), bonds_(bonds), bed_(bed) {
  scales_.reserve(rock.radii.size());
  for (const double r : rock.radii) {
    const Inertia inertia = inertia_of(r, rock.particle_density);
    scales_.push_back({1 / std::sqrt(inertia.mass), 1 / std::sqrt(inertia.moment)});
  }
}

DampedBond RockOperator::springs_of(const TemplateBond& bond) const {
  return damped_bond(bonds_, bond, inertia_of(rock_.radii[bond.i], rock_.particle_density),
                     inertia_of(rock_.radii[bond.j], rock_.particle_density));
}

/// Of unit mass.
BedSprings RockOperator::bed_of(std::size_t particle) const {
  const Inertia inertia = inertia_of(rock_.radii[particle], rock_.particle_density);
  const BedSprings s = bed_springs(bed_, rock_.radii[particle], inertia.mass);
  return {{s.translation.stiffness / inertia.mass, s.translation.damping / inertia.mass},
          {s.rotation.stiffness / inertia.moment, s.rotation.damping / inertia.moment}};
}

void RockOperator::set_step(double dt) {
  bond_factors_.clear();
  bond_factors_.reserve(rock_.bonds.size());
  const auto factor = [dt](const SpringDamper& s) { return dt * dt * s.stiffness + 2 * dt * s.damping; };
  for (const TemplateBond& bond : rock_.bonds) {
    const DampedBond s = springs_of(bond);
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
    const Scale &si = scales_[bond.i], &sj = scales_[bond.j];
    const BondFrame frame = bond_frame(rock_, bond);
    const Motion s = strain(frame, motion_of(x, bond.i, si.translation, si.rotation),
                            motion_of(x, bond.j, sj.translation, sj.rotation));
    const Vec3d& n = frame.n;
    const Vec3d force = e.shear * s.shift + ((e.normal - e.shear) * dot(n, s.shift)) * n;
    const Vec3d moment = e.bending * s.turn + ((e.twist - e.bending) * dot(n, s.turn)) * n;
    const Vec3d lever = cross(n, force);  // (rotation x n) . force = rotation . (n x force)
    add(result, bond.i, -si.translation * force, -si.rotation * (frame.arm_i * lever + moment));
    add(result, bond.j, sj.translation * force, sj.rotation * (moment - frame.arm_j * lever));
  }
}

double RockOperator::step_of_mode(const Eigen::VectorXd& v) const {
  double a = 0, b = 0;
  const auto strained = [&](const SpringDamper& s, double square) {
    a += s.stiffness * square;
    b += s.damping * square;
  };
  for (const TemplateBond& bond : rock_.bonds) {
    const Scale &si = scales_[bond.i], &sj = scales_[bond.j];
    const BondFrame frame = bond_frame(rock_, bond);
    const Motion s = strain(frame, motion_of(v, bond.i, si.translation, si.rotation),
                            motion_of(v, bond.j, sj.translation, sj.rotation));
    const DampedBond springs = springs_of(bond);
    const double stretch = dot(frame.n, s.shift), twist = dot(frame.n, s.turn);
    strained(springs.normal, stretch * stretch);
    strained(springs.shear, norm2(s.shift - stretch * frame.n));
    strained(springs.twist, twist * twist);
    strained(springs.bending, norm2(s.turn - twist * frame.n));
  }
  const auto weights = [&](std::size_t p) { return motion_of(v, static_cast<Index>(p), 1, 1); };
  for (std::size_t p = 0; p < scales_.size(); ++p) {
    const Motion m = weights(p);
    const BedSprings bed = bed_of(p);
    a += bed.translation.stiffness * norm2(m.shift) + bed.rotation.stiffness * norm2(m.turn);
  }
  return capped_step(a, b, bed_.damping_cap, [&](double dt) {
    BedDamping sum;
    for (std::size_t p = 0; p < scales_.size(); ++p) {
      const Motion m = weights(p);
      const BedSprings bed = bed_of(p);
      sum.add(norm2(m.shift), bed.translation.damping, dt, bed_.damping_cap);
      sum.add(norm2(m.turn), bed.rotation.damping, dt, bed_.damping_cap);
    }
    return sum;
  });
}

double RockOperator::gershgorin_step() const {
  struct RowSums {
    Six stiffness = Six::Zero(), damping = Six::Zero();
  };
  std::vector<RowSums> rows(scales_.size());
  for (const TemplateBond& bond : rock_.bonds) {
    const BondFrame frame = bond_frame(rock_, bond);
    const auto [normal, shear, twist, bending] = springs_of(bond);
    const std::array stiffness{normal.stiffness, shear.stiffness, twist.stiffness, bending.stiffness};
    const std::array damping{normal.damping, shear.damping, twist.damping, bending.damping};
    const End i{frame.arm_i, scales_[bond.i].translation, scales_[bond.i].rotation};
    const End j{frame.arm_j, scales_[bond.j].translation, scales_[bond.j].rotation};
    rows[bond.i].stiffness += row_sums(frame, stiffness, i, j);
    rows[bond.i].damping += row_sums(frame, damping, i, j);
    rows[bond.j].stiffness += row_sums(frame, stiffness, j, i);
    rows[bond.j].damping += row_sums(frame, damping, j, i);
  }
  double dt = infinite;
  for (std::size_t p = 0; p < rows.size(); ++p) {
    const BedSprings bed = bed_of(p);
    for (int k = 0; k < 6; ++k) {
      const SpringDamper& own = k < 3 ? bed.translation : bed.rotation;
      dt = std::min(dt, capped_step(rows[p].stiffness[k] + own.stiffness, rows[p].damping[k], bed_.damping_cap,
                                    [&](double step) {
                                      BedDamping single;
                                      single.add(1, own.damping, step, bed_.damping_cap);
                                      return single;
                                    }));
    }
  }
  return dt;
}

}  // namespace gyro
