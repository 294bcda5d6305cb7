// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/wall_merge.hpp"

namespace gyro {

/// A triangle with its unit normal (right-handed in a, b, c), prepared once.
struct WallTriangle {
  Vec3d a, b, c, normal;
};

/// Keeps the nearer of `best` and the point of the edge from a to b nearest to the centre.
GYRO_HD inline void keep_nearer_edge(const Vec3d& a, const Vec3d& b, const Vec3d& centre, Vec3d& best_offset,
                                     double& best2, Feature& feature) {
  const Vec3d edge = b - a, from_a = centre - a;
  const double along = dot(from_a, edge), length2 = norm2(edge);
  const bool at_a = along <= 0, at_b = along >= length2;
  const Vec3d offset = at_a ? from_a : at_b ? centre - b : from_a - along / length2 * edge;
  const double distance2 = norm2(offset);
  if (distance2 < best2) {
    best2 = distance2;
    best_offset = offset;
    feature = at_a || at_b ? Feature::vertex : Feature::edge;
  }
}

/// Closest point of a triangle to a sphere's centre, when the sphere overlaps it.
///
/// Both sides can be touched: the normal points from the triangle to the centre. Over the inside the
/// triangle's own normal is used, which no sliver spoils.
/// @return false when the distance is not below the radius
GYRO_HD inline bool near_triangle(const WallTriangle& t, const Vec3d& centre, double radius, NearPoint& result) {
  const double side = dot(centre - t.a, t.normal);
  const double height = side < 0 ? -side : side;
  if (height >= radius) return false;
  const Vec3d normal = side < 0 ? -t.normal : t.normal;
  const bool inside = dot(cross(t.normal, t.b - t.a), centre - t.a) >= 0 &&
                      dot(cross(t.normal, t.c - t.b), centre - t.b) >= 0 &&
                      dot(cross(t.normal, t.a - t.c), centre - t.c) >= 0;
  if (inside) {
    result = {normal, height, Feature::face};
    return true;
  }
  Vec3d offset{0, 0, 0};
  double best2 = radius * radius;
  Feature feature = Feature::face;
  keep_nearer_edge(t.a, t.b, centre, offset, best2, feature);
  keep_nearer_edge(t.b, t.c, centre, offset, best2, feature);
  keep_nearer_edge(t.c, t.a, centre, offset, best2, feature);
  if (feature == Feature::face) return false;
  const double distance = ::sqrt(best2);
  result = {distance > 0 ? 1 / distance * offset : normal, distance, feature};
  return true;
}

/// Touches of a sphere with the triangles `ids[0..count)` of a mesh, in the body frame.
/// The order of the ids and duplicates among them change nothing.
/// @param triangles  all triangles of the wall
GYRO_HD inline WallTouches touch_triangles(const WallTriangle* triangles, const Index* ids, Index count,
                                           const Vec3d& centre, double radius) {
  NearPoints<12> points;
  for (Index i = 0; i < count; ++i) {
    NearPoint p;
    if (near_triangle(triangles[ids[i]], centre, radius, p)) points.add(p);
  }
  return merged_touches(points, radius);
}

}  // namespace gyro
