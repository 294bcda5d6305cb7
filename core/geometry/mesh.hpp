// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <array>
#include <vector>

namespace gyro {

/// Triangles over shared vertices. A closed mesh is a solid when every edge is run through once
/// in each direction and the normals (right-hand rule) point outwards.
struct TriangleMesh {
  std::vector<Vec3d> vertices;
  std::vector<Vec3<Index>> triangles;
};

/// Volume integrals of the solid inside a closed mesh, at unit density.
struct MassProperties {
  double volume = 0;                ///< negative when the normals point inwards
  Vec3d centroid{0, 0, 0};          ///< of the volume
  std::array<double, 6> inertia{};  ///< xx, yy, zz, xy, yz, zx about the centroid (xy = -int x y)
};

/// Exact integrals over the polyhedron: a sum over the tetrahedra that the triangles make with the
/// first vertex (Tonon, J. Math. Stat. 1 (2005) 8). Meaningless for an open mesh.
MassProperties mass_properties(const TriangleMesh& mesh);

/// Principal moments and axes of a symmetric tensor {xx, yy, zz, xy, yz, zx}, ascending.
struct PrincipalAxes {
  Vec3d moments;
  std::array<Vec3d, 3> axes;  ///< unit, right-handed; axes[0] belongs to the smallest moment (the long axis)
};
PrincipalAxes principal_axes(const std::array<double, 6>& tensor);

/// How the triangles of a mesh meet at their edges.
struct EdgeCheck {
  Index open = 0;           ///< edges of one triangle
  Index crowded = 0;        ///< edges of more than two
  Index contradictory = 0;  ///< edges that two triangles run through in the same direction
  Index bodies = 0;         ///< sets of triangles connected by edges
  bool is_solid() const { return open + crowded + contradictory == 0 && bodies == 1; }
};
EdgeCheck check_edges(const TriangleMesh& mesh);

/// Corners of the smallest box along the axes. The mesh has at least one vertex.
struct Box {
  Vec3d low, high;
};
Box bounding_box(const TriangleMesh& mesh);

/// The same mesh with x -> scale * (x - origin).
TriangleMesh moved(TriangleMesh mesh, const Vec3d& origin, double scale);

}  // namespace gyro
