// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

namespace gyro {

/// One place where a sphere touches a wall.
struct WallTouch {
  Vec3d normal;   ///< unit, from the wall to the sphere
  double gap;     ///< distance from the sphere's surface to the wall, negative = overlap [m]
  double weight;  ///< share in (0, 1] by which the contact force counts [-]
};

/// All touches of a sphere with one wall, the deepest first.
struct WallTouches {
  static constexpr int capacity = 3;
  WallTouch touch[capacity];
  int count = 0;
};

/// Closest point of one piece of a wall (face, edge or corner alike), seen from the sphere's centre.
struct NearPoint {
  Vec3d normal;   ///< unit, from the point to the centre
  double height;  ///< distance from the point to the centre [m]
};

/// Deepest first. A total order: the result is the same whatever order the pieces come in.
GYRO_HD inline bool comes_before(const NearPoint& a, const NearPoint& b) {
  if (a.height != b.height) return a.height < b.height;
  if (a.normal.x != b.normal.x) return a.normal.x < b.normal.x;
  if (a.normal.y != b.normal.y) return a.normal.y < b.normal.y;
  return a.normal.z < b.normal.z;
}

/// Height of point a above the tangent plane of point b [m]; 0 when a lies on or below it.
GYRO_HD inline double rise_above(const NearPoint& a, const NearPoint& b) {
  constexpr double rounding = 1e-10;  // relative; below half the square of same_point
  const double rise = b.height - dot(a.normal, b.normal) * a.height;
  return rise > rounding * b.height ? rise : 0;
}

/// Two points are one when they are nearer than 3e-5 times their height. Pieces that share an edge or
/// a corner, coplanar pieces and duplicates give one point but for rounding. Seams flatter than 3e-5
/// radians fall under it too: there the normal steps by that angle.
GYRO_HD inline bool is_same(const NearPoint& a, const NearPoint& b) {
  constexpr double same_point = 3e-5;
  return norm2(a.height * a.normal - b.height * b.normal) <= same_point * same_point * (a.height * b.height);
}

/// The points of one wall that stand for themselves, deepest first.
///
/// A point is hidden when it is the same as a deeper one or lies on or below its tangent plane, as
/// the rim of a touched flat does, and a back face. With points that are nearest in their own
/// surroundings only (see PointsOfTriangles) faces so beat edges and edges beat corners.
struct VisiblePoints {
  static constexpr int capacity = 6;
  NearPoint point[capacity];
  int count = 0;

  GYRO_HD bool hide(const NearPoint& p) const {
    for (int i = 0; i < count; ++i)
      if (is_same(p, point[i]) || !(rise_above(p, point[i]) > 0)) return true;
    return false;
  }
};

/// Where on its piece a closest point lies.
enum class Place : int { out_of_reach, inside, rim };

/// Finds the deepest point which the points found so far do not hide.
///
/// Heights of equal points differ by rounding only, but the direction from a rim point has the
/// square root of that error. An inside point, whose normal is the piece's own, therefore comes first.
struct FindDeepest {
  const VisiblePoints& before;
  NearPoint inside{{0, 0, 0}, 0}, rim{{0, 0, 0}, 0};
  bool has_inside = false, has_rim = false;
  int offers = 0;  ///< points that were not hidden

  /// True when `p` would be the best of its kind so far.
  GYRO_HD bool wants(const NearPoint& p, Place place) {
    if (before.hide(p)) return false;
    ++offers;
    return place == Place::inside ? !has_inside || comes_before(p, inside) : !has_rim || comes_before(p, rim);
  }
  GYRO_HD void take(const NearPoint& p, Place place) {
    if (place == Place::inside) {
      inside = p;
      has_inside = true;
    } else {
      rim = p;
      has_rim = true;
    }
  }
  GYRO_HD bool found() const { return has_inside || has_rim; }
  GYRO_HD const NearPoint& best() const {
    if (!has_rim) return inside;
    return has_inside && (is_same(inside, rim) || comes_before(inside, rim)) ? inside : rim;
  }
};

/// The visible points of a wall: at each pass the deepest one left, so that a point is hidden by
/// visible ones only and nothing depends on order or on room for all points.
/// @param each_point  called as each_point(finder): offers all points nearer than the radius, by
///                    finder.wants(p, place) and then finder.take(p, place)
template <class EachPoint>
GYRO_HD VisiblePoints visible_points(const EachPoint& each_point) {
  VisiblePoints visible;
  while (visible.count < VisiblePoints::capacity) {
    FindDeepest finder{visible};
    each_point(finder);
    if (!finder.found()) break;
    visible.point[visible.count++] = finder.best();
    if (finder.offers == 1) break;
  }
  return visible;
}

}  // namespace gyro
