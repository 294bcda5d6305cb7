// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"
#include "core/rocks/stability.hpp"
#include "core/scene/scene.hpp"

#include <cmath>

namespace gyro {

/// A spring and its damper along one relative motion of two particles, or of a particle in its bed.
struct SpringDamper {
  double stiffness, damping;
};

/// Mass [kg] and moment of inertia [kg m2] of a particle.
struct Inertia {
  double mass, moment;
};

Inertia inertia_of(double radius, double density);

/// 1/sqrt of mass and moment of inertia: the scale of motions that has unit masses.
struct InverseRoot {
  double mass, moment;
  explicit InverseRoot(const Inertia& i) : mass(1 / std::sqrt(i.mass)), moment(1 / std::sqrt(i.moment)) {}
};

/// The springs of a bond (core/laws/bond/springs.hpp), each damped by c = 2 xi sqrt(k m_eff), m_eff = the pair's
/// reduced mass or moment of inertia.
struct DampedBond {
  SpringDamper normal, shear, twist, bending;
};

DampedBond damped_bond(const BondParameters& p, const RockTemplate& rock, const TemplateBond& bond);

/// Where the springs of a bond act: along n, and for shear at its middle, which is L_i and L_j from the two centres.
/// L_i + L_j = L0, so that angular momentum is conserved. Elongation and relative rotation of the bond are
///
///   u = x_j - x_i - (L_i rotation_i + L_j rotation_j) x n        theta = rotation_j - rotation_i
struct BondFrame {
  Vec3d n;  ///< from i to j
  double arm_i, arm_j;
};

inline BondFrame bond_frame(const RockTemplate& rock, const TemplateBond& bond) {
  const Vec3d d = rock.centres[bond.j] - rock.centres[bond.i];
  const double arm_i = (bond.length + rock.radii[bond.i] - rock.radii[bond.j]) / 2;
  return {(1 / norm(d)) * d, arm_i, bond.length - arm_i};
}

/// Springs and dampers of a particle in its bed, of each of the three directions (stability.hpp), divided by mass or
/// moment of inertia [1/s2, 1/s].
struct BedSprings {
  SpringDamper translation, rotation;
};

BedSprings scaled_bed(const BedContacts& bed, double radius, const Inertia& inertia);

}  // namespace gyro
