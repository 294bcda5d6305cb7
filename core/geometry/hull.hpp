// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

namespace gyro {

/// Convex hull as a closed mesh with outward normals, vertices in the order of the points. @param points  at least 4,
/// not all in one plane
TriangleMesh convex_hull(const std::vector<Vec3d>& points);

}  // namespace gyro
