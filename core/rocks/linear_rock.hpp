// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/stability.hpp"

#include <Eigen/SparseCore>

namespace gyro {

/// A rock linearised at rest, scaled to unit masses: M^-1/2 K M^-1/2 and M^-1/2 C M^-1/2 [1/s2, 1/s].
/// Six rows for each particle: x, y, z, then the rotations about them. The assembled form of RockOperator
/// (rock_operator.hpp), for static solutions (load_table.cpp, `verify`) and as a reference in tests: 25 to 33 kB a
/// particle while it is made. The cap on the bed's damping is not in it. Include it only there, because it needs Eigen.
struct LinearRock {
  Eigen::SparseMatrix<double> stiffness, damping;
  Eigen::VectorXd inverse_root_mass;  ///< 1/sqrt(m) or 1/sqrt(0.4 m R^2)
};

/// Matrices of the rock with all bonds intact, plus the bed contacts of every particle (stability.hpp).
LinearRock linearise(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed);

}  // namespace gyro
