// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <cstddef>
#include <vector>

namespace gyro {

/// The particles of a scene, one row each, in order of id.
struct ParticleSnapshot {
  std::vector<ParticleId> id;
  std::vector<RockId> rock;
  std::vector<Index> fragment;  ///< row of the first particle of the same fragment
  std::vector<Vec3d> position, velocity, angular_velocity;
  std::vector<Vec3d> force;  ///< sum of contact, wall and bond forces, without gravity [N]
  std::vector<double> radius, mass;
  std::size_t size() const { return id.size(); }
  /// Takes the memory of `rows` particles, but for `fragment`, which is found for all at once.
  void reserve(std::size_t rows) {
    id.reserve(rows);
    rock.reserve(rows);
    for (std::vector<Vec3d>* column : {&position, &velocity, &angular_velocity, &force}) column->reserve(rows);
    radius.reserve(rows);
    mass.reserve(rows);
  }
};

/// The intact bonds of a scene.
struct BondSnapshot {
  std::vector<Index> i, j;           ///< rows in the particle snapshot
  std::vector<double> normal_force;  ///< tension positive [N]
  std::vector<double> stress_ratio;  ///< larger of tension/strength and shear/strength [-]
  std::vector<double> radius;        ///< [m]
  std::size_t size() const { return i.size(); }
};

}  // namespace gyro
