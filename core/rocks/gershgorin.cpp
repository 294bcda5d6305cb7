// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/mode_step.hpp"
#include "core/rocks/rock_springs.hpp"
#include "core/rocks/stability.hpp"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace gyro {
namespace {

using Eigen::Matrix3d;
using Six = Eigen::Matrix<double, 6, 1>;
using Block = Eigen::Matrix<double, 6, 6>;

/// One end of a bond.
struct End {
  double sign;  ///< -1 for i, +1 for j
  double arm;
  Six scale;  ///< 1/sqrt of the masses
};

/// Rows of one particle in a matrix: the block on the diagonal, and sums of absolute values of the others.
struct Rows {
  Block own = Block::Zero();
  Six others = Six::Zero();
  Six sums() const { return own.cwiseAbs().rowwise().sum() + others; }
};

/// Springs, or dampers, of a bond.
struct Four {
  double normal, shear, twist, bending;
};

/// Adds the rows of a bond's end. With N = n n^T, P = 1 - N and X = [n]x, forces per shift are S = k_n N + k_s P,
/// moments per turn B = k_t N + k_b P, and a turn of an end shifts the bond's middle by arm X turn.
void add(Rows& rows, const Vec3d& direction, const Four& k, const End& own, const End& other) {
  const Eigen::Vector3d n(direction.x, direction.y, direction.z);
  const Matrix3d along = n * n.transpose(), across = Matrix3d::Identity() - along;
  Matrix3d crossed;
  crossed << 0, -n[2], n[1], n[2], 0, -n[0], -n[1], n[0], 0;
  const Matrix3d forces = k.normal * along + k.shear * across, moments = k.twist * along + k.bending * across;
  const auto block = [&](const End& column, double same) -> Block {  // same: +1 on the diagonal, -1 beside it
    Block b;
    b << same * forces, own.sign * column.arm * k.shear * crossed, -column.sign * own.arm * k.shear * crossed,
        own.arm * column.arm * k.shear * across + same * moments;
    return own.scale.asDiagonal() * b * column.scale.asDiagonal();
  };
  rows.own += block(own, 1);
  rows.others += block(other, -1).cwiseAbs().rowwise().sum();
}

/// The bonds of each particle: those of particle p are list[begin[p]] .. list[begin[p + 1] - 1].
struct BondsOfParticles {
  std::vector<Index> begin, list;
  explicit BondsOfParticles(const RockTemplate& rock);
};

BondsOfParticles::BondsOfParticles(const RockTemplate& rock)
    : begin(rock.radii.size() + 1), list(2 * rock.bonds.size()) {
  for (const TemplateBond& b : rock.bonds) ++begin[b.i], ++begin[b.j];
  Index sum = 0;
  for (Index& count : begin) count = (sum += count);  // the end of each; filling moves it to the beginning
  for (std::size_t k = rock.bonds.size(); k-- > 0;) {
    list[--begin[rock.bonds[k].i]] = static_cast<Index>(k);
    list[--begin[rock.bonds[k].j]] = static_cast<Index>(k);
  }
}

/// The step at which the largest row sum of a particle is 4.
double particle_step(const Rows& stiffness, const Rows& damping, const BedSprings& bed, double cap) {
  const Six a = stiffness.sums(), b = damping.sums();
  double dt = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 6; ++k) {
    const SpringDamper& own = k < 3 ? bed.translation : bed.rotation;
    const auto damper = [&](double step) {
      BedDamping single;
      single.add(1, own.damping, step, cap);
      return single;
    };
    dt = std::min(dt, capped_step(a[k] + own.stiffness, b[k], cap, damper));
  }
  return dt;
}

}  // namespace

double gershgorin_step(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed) {
  const BondsOfParticles bonds_of(rock);
  const auto end = [&](Index particle, double sign, double arm) {
    const Inertia inertia = inertia_of(rock.radii[particle], rock.particle_density);
    const InverseRoot scale(inertia);
    Six six;
    six << Eigen::Vector3d::Constant(scale.mass), Eigen::Vector3d::Constant(scale.moment);
    return End{sign, arm, six};
  };
  double dt = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < rock.radii.size(); ++p) {
    Rows stiffness, damping;
    for (Index at = bonds_of.begin[p]; at < bonds_of.begin[p + 1]; ++at) {
      const TemplateBond& bond = rock.bonds[bonds_of.list[at]];
      const BondFrame frame = bond_frame(rock, bond);
      const DampedBond s = damped_bond(bonds, rock, bond);
      End own = end(bond.i, -1, frame.arm_i), other = end(bond.j, 1, frame.arm_j);
      if (static_cast<std::size_t>(bond.j) == p) std::swap(own, other);
      add(stiffness, frame.n, {s.normal.stiffness, s.shear.stiffness, s.twist.stiffness, s.bending.stiffness}, own,
          other);
      add(damping, frame.n, {s.normal.damping, s.shear.damping, s.twist.damping, s.bending.damping}, own, other);
    }
    const BedSprings own_bed = scaled_bed(bed, rock.radii[p], inertia_of(rock.radii[p], rock.particle_density));
    dt = std::min(dt, particle_step(stiffness, damping, own_bed, bed.damping_cap));
  }
  return dt;
}

}  // namespace gyro
