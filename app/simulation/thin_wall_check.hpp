// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"
#include "core/surfaces/mesh_grid.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Finds particles that touch each other through a mesh wall.
///
/// Contacts of particles do not know of walls: where a sheet is thinner than the overlaps on its two sides together,
/// what lies there pushes through it. Planes and profiles have one side only.
class ThinWallCheck {
 public:
  explicit ThinWallCheck(const Scene& scene);

  /// The first such pair, in words; nothing if there is none.
  std::optional<std::string> find(const ParticleSnapshot& particles, std::span<const WallPose> poses) const;

 private:
  struct Sheet {
    std::size_t wall;
    std::string name;
    MeshGrid grid;
  };
  static std::optional<std::string> find_through(const Sheet& sheet, const WallPose& pose,
                                                 const ParticleSnapshot& particles);

  std::vector<Sheet> thin_walls_;
};

}  // namespace gyro
