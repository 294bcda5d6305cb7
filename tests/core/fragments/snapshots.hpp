// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"

#include <numbers>

namespace gyro {

/// Adds one fragment of equal spheres to a snapshot.
inline void add_fragment(ParticleSnapshot& p, const std::vector<Vec3d>& centres, double radius, double density,
                         const Vec3d& shift, RockId rock = 0) {
  const auto first = static_cast<Index>(p.size());
  for (const Vec3d& c : centres) {
    p.id.push_back(static_cast<ParticleId>(p.size()));
    p.rock.push_back(rock);
    p.fragment.push_back(first);
    p.position.push_back(c + shift);
    p.velocity.push_back({0, 0, 0});
    p.angular_velocity.push_back({0, 0, 0});
    p.force.push_back({0, 0, 0});
    p.radius.push_back(radius);
    p.mass.push_back(density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
  }
}

/// Centres of a block of nx x ny x nz touching spheres.
inline std::vector<Vec3d> block(int nx, int ny, int nz, double radius) {
  std::vector<Vec3d> centres;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) centres.push_back({2 * radius * i, 2 * radius * j, 2 * radius * k});
    }
  }
  return centres;
}

}  // namespace gyro
