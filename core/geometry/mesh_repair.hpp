// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

namespace gyro {

/// Merges vertices that lie within the distance of an earlier one; drops vertices that no
/// triangle uses. @param distance  [unit of the mesh]
TriangleMesh weld(const TriangleMesh& soup, double distance);

/// Number of triangles that were dropped, by reason.
struct Dropped {
  Index flat = 0;      ///< two equal corners
  Index repeated = 0;  ///< the corners of an earlier triangle, in any order
};
/// Drops triangles with two equal corners and repeated triangles. Thin triangles with three different corners stay,
/// because the mesh would have holes without them.
Dropped drop_useless_triangles(TriangleMesh& mesh);

/// Flips triangles until neighbours have their common edge in opposite directions and the volume is positive. Of each
/// connected set the smaller part is flipped. Only edges of exactly two triangles connect triangles. @return number of
/// triangles flipped
Index orient_outwards(TriangleMesh& mesh);

/// Drops bodies (sets of triangles connected by edges) with less volume than `share` x that of the largest body, such
/// as the floating specks of scanners. @return number of bodies dropped
Index drop_specks(TriangleMesh& mesh, double share);

}  // namespace gyro
