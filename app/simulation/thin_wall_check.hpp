// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"
#include "core/scene/snapshot.hpp"
#include "core/surfaces/mesh_grid.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Finds particles that touch each other through a mesh wall.
///
/// Contacts between particles do not look at walls. Where a mesh wall is thinner than the overlaps on its two sides
/// together, particles on either side push each other through it. Planes and profiles have one side only.
class ThinWallCheck {
 public:
  explicit ThinWallCheck(const Scene& scene);

  /// A message about the first such pair; nothing if there is none.
  /// @param poses  of all walls of the scene
  std::optional<std::string> find(const ParticleSnapshot& particles, std::span<const WallPose> poses) const;

 private:
  struct MeshWall {
    std::size_t number;  ///< in the scene
    std::string name;
    MeshGrid grid;
  };
  static std::optional<std::string> find_through(const MeshWall& wall, const WallPose& pose,
                                                 const ParticleSnapshot& particles);

  std::vector<MeshWall> mesh_walls_;
};

}  // namespace gyro
