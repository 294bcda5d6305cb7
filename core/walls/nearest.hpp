// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surfaces/mesh_grid.hpp"

namespace gyro {

/// The point of a mesh nearest to a given point.
struct Nearest {
  Index triangle = none;
  NearPoint point{};  ///< normal from the mesh to the point, and the distance
};

/// Searches within `reach` [m]; `triangle` is none if there is no triangle. Body frame.
Nearest nearest_within(const MeshGrid& mesh, const Vec3d& centre, double reach);

/// Searches within `reach` [m]; as long as there is no triangle, four times farther, up to 64 x reach. Body frame.
Nearest nearest_triangle(const MeshGrid& mesh, const Vec3d& centre, double reach);

}  // namespace gyro
