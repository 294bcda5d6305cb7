// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <array>

namespace gyro {

/// Volume integrals of the solid inside a closed mesh, at unit density.
struct MassProperties {
  double volume = 0;                ///< negative when the normals point inwards [m3]
  Vec3d centroid{0, 0, 0};          ///< of the volume [m]
  std::array<double, 6> inertia{};  ///< xx, yy, zz, xy, yz, zx about the centroid (xy = -int x y) [m5]
};

/// Exact integrals over the polyhedron: a sum over the tetrahedra that the triangles make with the
/// first vertex (Tonon, J. Math. Stat. 1 (2005) 8). The result is meaningless for an open mesh.
MassProperties mass_properties(const TriangleMesh& mesh);

/// Sum of the triangles' areas [m2].
double surface_area(const TriangleMesh& mesh);

/// Corners of the smallest box along the axes [m].
struct Box {
  Vec3d low, high;
};
/// @param mesh with at least one vertex
Box bounding_box(const TriangleMesh& mesh);

/// Area of a triangle [m2].
double triangle_area(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// The same mesh with x -> scale * (x - origin).
TriangleMesh moved(TriangleMesh mesh, const Vec3d& origin, double scale);

}  // namespace gyro
