// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh.hpp"

namespace gyro {

/// Sum of the triangles' areas.
double surface_area(const TriangleMesh& mesh);

/// What the closing of holes came to.
struct ClosedHoles {
  Index closed = 0;        ///< holes
  double largest = 0;      ///< area of the largest hole that was closed
  double too_large = 0;    ///< area of the smallest hole that was left, 0 if none
  bool ambiguous = false;  ///< holes meet in a point, so that their rims cannot be told apart; nothing was closed
};

/// Closes every hole whose area is at most `largest_share` of the surface by a fan of triangles about the middle of its
/// rim. The area of a hole is that of its fan: a slit of any length has none. Needs triangles that agree about their
/// side (turn_outwards).
ClosedHoles close_holes(TriangleMesh& mesh, double largest_share);

/// Drops bodies (sets of triangles connected by edges) of less than the share of the largest one's volume, as scanners
/// leave them floating. @return how many
Index drop_specks(TriangleMesh& mesh, double share);

}  // namespace gyro
