// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <array>
#include <utility>
#include <vector>

namespace gyro {

/// A directed edge of a triangle: from one vertex to the next.
using Edge = std::pair<Index, Index>;

/// The three directed edges of a triangle, in its order.
std::array<Edge, 3> edges_of(const Vec3<Index>& triangle);

/// The same edge with its lower vertex first.
Edge undirected(const Edge& edge);

/// Counts of how the triangles of a mesh share edges.
struct EdgeCheck {
  Index open = 0;           ///< edges of one triangle
  Index crowded = 0;        ///< edges of more than two
  Index contradictory = 0;  ///< edges of two triangles that have them in the same direction
  Index bodies = 0;         ///< sets of triangles connected by edges
  bool is_solid() const { return open + crowded + contradictory == 0 && bodies == 1; }
};
EdgeCheck check_edges(const TriangleMesh& mesh);

/// The body of every triangle. A body is a set of triangles connected by edges; its number is its first triangle.
std::vector<Index> bodies_of(const TriangleMesh& mesh);

}  // namespace gyro
