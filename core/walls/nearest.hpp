// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surfaces/mesh_grid.hpp"

namespace gyro {

/// The piece of a mesh nearest to a point.
struct Nearest {
  Index triangle = none;
  NearPoint point{};  ///< normal from the mesh to the point, and the distance
};

/// Searches within `reach` only; without a triangle there, `triangle` is none. Body frame.
Nearest nearest_within(const MeshGrid& mesh, const Vec3d& centre, double reach);

/// Searches within `reach`; if no triangle is there, four times farther, up to 64 x reach. Body frame.
Nearest nearest_triangle(const MeshGrid& mesh, const Vec3d& centre, double reach);

}  // namespace gyro
