// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/hull.hpp"

#include <cmath>
#include <vector>

namespace gyro {

/// A block with a corner at `low`, normals outwards.
inline TriangleMesh block(const Vec3d& size, const Vec3d& low = {0, 0, 0}) {
  std::vector<Vec3d> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back(low + Vec3d{k & 1 ? size.x : 0, k & 2 ? size.y : 0, k & 4 ? size.z : 0});
  }
  return {corners,
          {{0, 2, 1},
           {1, 2, 3},
           {4, 5, 6},
           {5, 7, 6},
           {0, 1, 4},
           {1, 5, 4},
           {2, 6, 3},
           {3, 6, 7},
           {0, 4, 2},
           {2, 4, 6},
           {1, 3, 5},
           {3, 7, 5}}};
}

/// An L of three unit cubes, which is not convex: [0,2]x[0,1] and [0,1]x[1,2], 0 < z < 1.
inline TriangleMesh corner_piece() {
  const std::vector<Vec3d> outline{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  TriangleMesh mesh{outline, {}};
  for (const Vec3d& p : outline) mesh.vertices.push_back({p.x, p.y, 1});
  for (const Vec3<Index>& t : {Vec3<Index>{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}}) {
    mesh.triangles.push_back({t.x, t.z, t.y});
    mesh.triangles.push_back({t.x + 6, t.y + 6, t.z + 6});
  }
  for (Index k = 0; k < 6; ++k) {
    const Index n = (k + 1) % 6;
    mesh.triangles.push_back({k, n, n + 6});
    mesh.triangles.push_back({k, n + 6, k + 6});
  }
  return mesh;
}

/// Hull of points on an ellipsoid.
inline TriangleMesh ellipsoid(double a, double b, double c, int points) {
  std::vector<Vec3d> surface;
  for (int k = 0; k < points; ++k) {
    const double z = 1 - (2 * k + 1.0) / points, r = std::sqrt(1 - z * z), azimuth = 2.399963229728653 * k;
    surface.push_back({a * r * std::cos(azimuth), b * r * std::sin(azimuth), c * z});
  }
  return convex_hull(surface);
}

}  // namespace gyro
