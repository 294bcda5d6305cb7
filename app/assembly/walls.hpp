// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/concave_outline.hpp"
#include "core/scene/scene.hpp"
#include "core/walls/liners.hpp"
#include "core/walls/mesh_chamber.hpp"
#include "io/case/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// A wall as snapshots show it.
struct WallPicture {
  TriangleMesh mesh;  ///< body frame
  Index wall;         ///< in the scene
};

/// The walls of a case; the mantle is lifted to its setting.
struct CaseWalls {
  std::vector<Wall> walls;
  std::optional<Liners> liners;       ///< of a crusher given by its profile
  std::vector<WallPicture> pictures;  ///< one per wall
  std::vector<std::string> notes;     ///< extents and repairs of mesh files, and the lift of the mantle, for the log
  std::vector<std::string> doubts;    ///< notes on meshes that are probably in another unit, frame or position
};

/// Reads mesh files, makes liners from a profile and lifts a mantle of meshes to the closed side setting.
/// @throws BadKey for files that cannot be used and settings that the liners cannot have
CaseWalls make_walls(const Case& input);

/// Mantle and concave where both are meshes: the first wall that gyrates, and the fixed one called concave.
std::optional<MeshLiners> mesh_liners(std::span<const Wall> walls);

/// Inner radius by height of the fixed wall called concave, if it is a profile or a mesh: of a mesh its innermost
/// surface, at each height the largest radius of all azimuths. None without such a wall.
/// @throws BadInput for a mesh that is not closed around the axis
std::optional<ConcaveOutline> concave_outline(std::span<const Wall> walls);

/// Liners of a crusher with a profile. @throws BadInput for settings that the profile cannot have
Liners liners_of(const CaseCrusher& crusher);

}  // namespace gyro
