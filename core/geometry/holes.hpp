// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

namespace gyro {

/// Result of close_holes.
struct ClosedHoles {
  Index closed = 0;        ///< number of holes closed
  double largest = 0;      ///< area of the largest hole that was closed [unit of the mesh, squared]
  double too_large = 0;    ///< area of the smallest hole that stays open; 0 if none
  bool ambiguous = false;  ///< holes share a vertex, so that their rims cannot be separated; no hole was closed
};

/// Closes every hole whose area is at most `max_share` of the surface by a fan of triangles about the centre of its
/// rim. The area of a hole is that of its fan, so the area of a slit is 0. The triangles must be oriented consistently
/// (orient_outwards).
ClosedHoles close_holes(TriangleMesh& mesh, double max_share);

}  // namespace gyro
