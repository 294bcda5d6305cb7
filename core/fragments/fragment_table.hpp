// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"

#include <span>
#include <vector>

namespace gyro {

/// One fragment: particles that are bonded together, or a single particle.
struct Fragment {
  Index first_particle;  ///< row in the snapshot, the lowest of the fragment
  Index particles;       ///< number of particles

  RockId rock;     ///< of which it is a part
  double mass;     ///< [kg]
  double lowest;   ///< z of the lowest point of its spheres [m]
  double highest;  ///< z of the highest point of its spheres [m]
  Vec3d centre;    ///< centre of mass [m]
};

/// The fragments of a snapshot, in order of their first particle.
struct FragmentTable {
  std::vector<Fragment> rows;
  std::vector<Index> members_begin;  ///< [rows + 1] into members
  std::vector<Index> members;        ///< snapshot rows, ascending within a fragment

  std::size_t size() const { return rows.size(); }
  std::span<const Index> members_of(std::size_t row) const;
};

/// Collects the particles of a snapshot into fragments by its `fragment` column.
/// Linear in the number of particles.
FragmentTable fragment_table(const ParticleSnapshot& particles);

/// Diameter of the sphere of solid rock that has this mass [m]: (6 m / (pi rho))^(1/3).
/// @param mass          [kg]
/// @param rock_density  of solid rock [kg/m3]
double equal_mass_diameter(double mass, double rock_density);

/// Sieve size of a fragment [m]: that of its spheres (core/geometry/sieve_size.hpp), but at least the equal-mass
/// diameter of its heaviest particle.
/// @param row           of the table
/// @param rock_density  of solid rock [kg/m3]
double sieve_size(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles, double rock_density);

}  // namespace gyro
