// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh.hpp"

namespace gyro {

/// Makes one vertex of all that lie within the distance of the first of them; drops vertices that no
/// triangle uses.
TriangleMesh weld(const TriangleMesh& soup, double distance);

/// Drops triangles with two equal corners and repeats of a triangle (same corners, in any order).
/// Thin triangles with three corners stay: without them the mesh would have holes. @return how many of each
struct Dropped {
  Index flat = 0, repeated = 0;
};
Dropped drop_useless_triangles(TriangleMesh& mesh);

/// Turns triangles until neighbours run through their common edge in opposite directions and the
/// volume is positive. Of each connected set the smaller part is turned. Edges of other than two
/// triangles are not crossed. @return triangles turned
Index turn_outwards(TriangleMesh& mesh);

}  // namespace gyro
