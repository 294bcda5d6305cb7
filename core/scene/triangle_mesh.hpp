// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <vector>

namespace gyro {

/// Triangles over shared vertices: the surface of a wall, open or closed, or the shape of a rock.
///
/// A closed mesh is a solid if every edge is run through once in each direction and the normals (right-hand rule) point
/// outwards. Rocks need a solid; of a wall both sides can be touched.
struct TriangleMesh {
  std::vector<Vec3d> vertices;         ///< [m]
  std::vector<Vec3<Index>> triangles;  ///< three vertices each
};

}  // namespace gyro
