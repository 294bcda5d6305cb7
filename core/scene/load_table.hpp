// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

#include <cstddef>
#include <vector>

namespace gyro {

/// Number of loads on a particle: three forces and three moments. Number of stresses of a bond that they cause:
/// tension, shear in two directions, bending in two directions, torsion, each over its strength.
inline constexpr int point_loads = 6, bond_stresses = 6;
/// Numbers of a bond in a LoadRow: two bounds and the responses.
inline constexpr int load_row_width = 2 + point_loads * bond_stresses;

/// Largest number of particles in a rock that moves as a rigid body. Its load table takes 152 bytes a particle and
/// bond: 7.8 MB for 138 particles, 73 MB for 400.
inline constexpr Index max_rigid_particles = 400;

/// What loads on one particle do to all bonds of its rock, bond by bond for each number. Float is float or const float.
template <class Float>
struct LoadRow {
  Float* numbers;
  Index bonds;

  GYRO_HD Float* force() const { return numbers; }           ///< [1/N]
  GYRO_HD Float* moment() const { return numbers + bonds; }  ///< [1/(N m)]
  GYRO_HD Float* response(int load, int stress) const {      ///< [1/N, 1/(N m)]
    return numbers + static_cast<std::ptrdiff_t>(2 + load * bond_stresses + stress) * bonds;
  }
};

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
  std::vector<float> numbers;  ///< a LoadRow for each particle

  LoadTable() = default;
  /// All zero.
  LoadTable(Index of_particles, Index of_bonds)
      : particles(of_particles),
        bonds(of_bonds),
        numbers(static_cast<std::size_t>(of_particles) * static_cast<std::size_t>(of_bonds) * load_row_width) {}

  LoadRow<float> row(Index particle) { return {numbers.data() + begin_of(particle), bonds}; }
  LoadRow<const float> row(Index particle) const { return {numbers.data() + begin_of(particle), bonds}; }

 private:
  std::size_t begin_of(Index particle) const {
    return static_cast<std::size_t>(particle) * static_cast<std::size_t>(bonds) * load_row_width;
  }
};

/// Makes rows of a load table when they are needed: of one rock or piece, whose table would be used once.
class LoadResponse {
 public:
  virtual ~LoadResponse() = default;
  virtual void fill(Index particle, const LoadRow<float>& to) const = 0;
};

}  // namespace gyro
