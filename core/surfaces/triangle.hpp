// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surfaces/merge.hpp"

namespace gyro {

/// A triangle with its unit normal (right-handed in a, b, c), prepared once.
struct WallTriangle {
  Vec3d a, b, c, normal;
};

/// Keeps the nearer of `best` and the point of the edge from a to b nearest to the centre.
GYRO_HD inline void keep_nearer_edge(const Vec3d& a, const Vec3d& b, const Vec3d& centre, Vec3d& best_offset,
                                     double& best2) {
  const Vec3d edge = b - a, from_a = centre - a;
  const double along = dot(from_a, edge), length2 = norm2(edge);
  const bool at_a = along <= 0, at_b = along >= length2;
  const Vec3d offset = at_a ? from_a : at_b ? centre - b : from_a - along / length2 * edge;
  const double distance2 = norm2(offset);
  if (distance2 < best2) {
    best2 = distance2;
    best_offset = offset;
  }
}

/// Closest point of a triangle to a sphere's centre, when the sphere overlaps it.
///
/// Both sides can be touched: the normal points from the triangle to the centre. Over the inside the
/// triangle's own normal is used.
GYRO_HD inline Place near_triangle(const WallTriangle& t, const Vec3d& centre, double radius, NearPoint& result) {
  const double side = dot(centre - t.a, t.normal);
  const double height = side < 0 ? -side : side;
  if (height >= radius) return Place::out_of_reach;
  const Vec3d normal = side < 0 ? -t.normal : t.normal;
  const bool inside = dot(cross(t.normal, t.b - t.a), centre - t.a) >= 0 &&
                      dot(cross(t.normal, t.c - t.b), centre - t.b) >= 0 &&
                      dot(cross(t.normal, t.a - t.c), centre - t.c) >= 0;
  if (inside) {
    result = {normal, height};
    return Place::inside;
  }
  Vec3d offset{0, 0, 0};
  double best2 = radius * radius;
  keep_nearer_edge(t.a, t.b, centre, offset, best2);
  keep_nearer_edge(t.b, t.c, centre, offset, best2);
  keep_nearer_edge(t.c, t.a, centre, offset, best2);
  if (!(best2 < radius * radius)) return Place::out_of_reach;
  const double distance = ::sqrt(best2);
  result = {distance > 0 ? 1 / distance * offset : normal, distance};
  return Place::rim;
}

/// True when the triangle holds the point `p` seen from the centre, but has a nearer one: then `p`
/// is no place of its own, the surface comes closer beside it. (Edges of a concave mesh.)
GYRO_HD inline bool surpasses(const WallTriangle& t, const NearPoint& p, const Vec3d& centre) {
  constexpr double crack = 1e-5;  // relative: joins the edges of files with single precision
  NearPoint nearer, unused;
  return near_triangle(t, centre - p.height * p.normal, crack * p.height, unused) != Place::out_of_reach &&
         near_triangle(t, centre, p.height, nearer) != Place::out_of_reach && !is_same(nearer, p);
}

/// The points of listed triangles that a sphere overlaps and that are nearest in their surroundings.
struct PointsOfTriangles {
  const WallTriangle* triangles;
  const Index* ids;
  Index count;
  Vec3d centre;
  double radius;

  GYRO_HD void operator()(FindDeepest& finder) const {
    for (Index i = 0; i < count; ++i) {
      NearPoint p;
      const Place place = near_triangle(triangles[ids[i]], centre, radius, p);
      if (place == Place::out_of_reach || !finder.wants(p, place)) continue;
      // The very deepest point needs no check, it is found in the first pass.
      if (place == Place::inside || finder.before.count == 0 || is_nearest_around(p)) finder.take(p, place);
    }
  }
  GYRO_HD bool is_nearest_around(const NearPoint& p) const {
    for (Index i = 0; i < count; ++i)
      if (surpasses(triangles[ids[i]], p, centre)) return false;
    return true;
  }
};

/// Touches of a sphere with the triangles `ids[0..count)` of a mesh, in the body frame.
/// The order of the ids and duplicates among them change nothing.
/// @param triangles  all triangles of the wall
GYRO_HD inline WallTouches touch_triangles(const WallTriangle* triangles, const Index* ids, Index count,
                                           const Vec3d& centre, double radius) {
  return merged_touches(visible_points(PointsOfTriangles{triangles, ids, count, centre, radius}), radius);
}

}  // namespace gyro
