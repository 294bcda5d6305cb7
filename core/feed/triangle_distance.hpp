// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

#include <algorithm>

namespace gyro {

/// A triangle with its unit normal.
struct FlatTriangle {
  Vec3d a, b, c, normal;
};

/// Square of the distance of a point to a segment [m2].
inline double distance2_to_segment(const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  const Vec3d edge = b - a;
  const double t = std::clamp(dot(p - a, edge) / norm2(edge), 0.0, 1.0);
  return norm2(p - a - t * edge);
}

/// Square of the distance of a point to a triangle [m2]: to its plane if the projection of the point is inside the
/// triangle, otherwise to its nearest edge.
inline double distance2_to_triangle(const FlatTriangle& t, const Vec3d& p) {
  const auto left_of = [&](const Vec3d& from, const Vec3d& to) {
    return dot(cross(t.normal, to - from), p - from) >= 0;
  };
  if (left_of(t.a, t.b) && left_of(t.b, t.c) && left_of(t.c, t.a)) {
    const double height = dot(p - t.a, t.normal);
    return height * height;
  }
  return std::min(distance2_to_segment(t.a, t.b, p),
                  std::min(distance2_to_segment(t.b, t.c, p), distance2_to_segment(t.c, t.a, p)));
}

}  // namespace gyro
