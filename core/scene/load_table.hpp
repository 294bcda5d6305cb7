// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

#include <cstddef>
#include <vector>

namespace gyro {

/// Number of loads on a particle: three forces and three moments. Number of stresses of a bond that they cause:
/// tension, shear in two directions, bending in two directions, torsion, each over its strength.
inline constexpr int point_loads = 6, bond_stresses = 6;

/// Largest number of particles in a rock with a load table, which takes 152 bytes a particle and bond: 7.8 MB for 138
/// particles, 73 MB for 400.
inline constexpr Index max_rigid_particles = 400;

/// How loads on the particles of a rock stress its bonds while the rock moves as a rigid body. Plain data, in the frame
/// of the rock's template (NewRock::orientation); core/rocks/load_table.hpp makes it.
///
/// Exactly, with L_ic the load c on particle i, the stresses of bond b are
///
///   s_r = sum over i, c of L_ic response[i][c][r][b]       ratio = max(s_0 + |(s_3, s_4)|, |(s_1, s_2)| + |s_5|) / f_b
///
/// with f_b the strength factor of the bond. A bound that needs no directions, and is some times larger:
///
///   ratio <= sum over i of (|F_i| force[i][b] + |M_i| moment[i][b]) / f_b
struct LoadTable {
  Index particles = 0, bonds = 0;
  std::vector<float> force;     ///< [particle * bonds + bond] [1/N]
  std::vector<float> moment;    ///< likewise [1/(N m)]
  std::vector<float> response;  ///< [((particle * 6 + load) * 6 + stress) * bonds + bond] [1/N, 1/(N m)]

  std::size_t place(Index particle, Index bond) const {
    return static_cast<std::size_t>(particle) * static_cast<std::size_t>(bonds) + static_cast<std::size_t>(bond);
  }
};

}  // namespace gyro
