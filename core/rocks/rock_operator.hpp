// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_springs.hpp"

#include <Eigen/Core>

#include <vector>

namespace gyro {

/// A rock linearised at rest and scaled to unit masses, as an operator that is computed from the bonds whenever it is
/// applied. A vector has six values of each particle: x, y, z, then the rotations about them.
///
///   A(dt) = dt^2 K + 2 dt C + min(2 dt c, 2 beta)      K, C of unit masses; c the bed's damping of each value, beta
///   its
///                                                      cap
///
/// Its largest eigenvalue grows with dt, and is 4 at the largest stable step.
///
/// Four factors of each bond are kept, 32 bytes; normal and arms are computed again from the centres. With five vectors
/// a rock of 20,000 particles and 61,600 bonds takes 367 bytes a particle. If normals and arms were kept too: 491 bytes
/// in 0.78 of the time; if the factors were computed again too: 268 bytes in 1.34 of the time.
class RockOperator {
 public:
  /// Keeps a reference to the rock.
  RockOperator(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed);

  Eigen::Index size() const { return static_cast<Eigen::Index>(6 * scales_.size()); }

  /// Sets the step [s] of apply().
  void set_step(double dt);
  /// result = A(dt) x
  void apply(const Eigen::VectorXd& x, Eigen::VectorXd& result) const;
  /// The step [s] at which v A(dt) v = 4 v v; infinity if there is none. An upper bound on the largest stable step.
  double step_of_mode(const Eigen::VectorXd& v) const;

 private:
  struct BondFactors {
    double normal, shear, twist, bending;  ///< dt^2 k + 2 dt c
  };
  struct BedFactors {
    double translation, rotation;
  };
  BedSprings bed_of(std::size_t particle) const;

  const RockTemplate& rock_;
  BondParameters bonds_;
  BedContacts bed_;
  std::vector<InverseRoot> scales_;
  std::vector<BondFactors> bond_factors_;
  std::vector<BedFactors> bed_factors_;
};

}  // namespace gyro
