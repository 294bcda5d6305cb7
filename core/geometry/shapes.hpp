// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh.hpp"

#include <cstdint>

namespace gyro {

/// A rock's shape: a solid of unit volume, centroid at the origin, principal axes along x (long), y, z.
struct RockShape {
  TriangleMesh surface;
  Vec3d inertia{0, 0, 0};  ///< principal moments at unit density about the centroid, ascending [m5]
  TriangleMesh preview;    ///< the surface, or its convex hull where the surface has above 2000 triangles
  double sieve_size = 0;   ///< smallest square mesh that lets the shape through [m]
};

/// Brings a solid mesh into that form. @param solid closed, normals outwards, of positive volume
RockShape make_shape(const TriangleMesh& solid);

/// A random convex polyhedron like crushed rock: the hull of 16 to 32 points, evenly spread on an
/// ellipsoid and jittered along it and across it. Axis ratios b/a and c/b are uniform in
/// 0.65 to 0.95, which spans the elongation and flatness of crushed aggregate.
/// @param number the shape's number under this seed
RockShape procedural_shape(std::uint64_t seed, std::uint64_t number);

}  // namespace gyro
