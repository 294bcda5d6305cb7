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

/// What a closest point lies on. Only used to prefer the best known normal.
enum class Feature : int { face = 0, edge = 1, vertex = 2 };

/// Closest point of one piece of a wall, seen from the sphere's centre.
struct NearPoint {
  Vec3d normal;   ///< unit, from the point to the centre
  double height;  ///< distance from the point to the centre [m]
  Feature feature;
};

/// Total order: deterministic whatever order the pieces come in.
GYRO_HD inline bool comes_before(const NearPoint& a, const NearPoint& b) {
  if (a.height != b.height) return a.height < b.height;
  if (a.normal.x != b.normal.x) return a.normal.x < b.normal.x;
  if (a.normal.y != b.normal.y) return a.normal.y < b.normal.y;
  return a.normal.z < b.normal.z;
}

/// The distinct points of one wall that a sphere overlaps, each counted once.
///
/// Pieces that share an edge or a vertex, coplanar pieces and duplicates give the same closest
/// point. Two points are the same when they are nearer than `same_point` times the height; the one
/// on the better feature (face, edge, vertex) stays. Only for seams flatter than `same_point`
/// radians does that replace the smooth change of weights, and its step is as small as that angle.
template <int Capacity>
struct NearPoints {
  static constexpr double same_point = 3e-5;

  NearPoint point[Capacity];
  int count = 0;

  GYRO_HD void add(const NearPoint& candidate) {
    NearPoint kept = candidate;
    int place = count;
    for (int i = 0; i < count; ++i)
      if (is_same(point[i], kept)) {
        const bool better =
            kept.feature != point[i].feature ? kept.feature < point[i].feature : comes_before(kept, point[i]);
        if (!better) return;
        place = i;
        break;
      }
    if (place == count) {
      if (count < Capacity) {
        ++count;
      } else {
        place = shallowest();
        if (!comes_before(kept, point[place])) return;
      }
    }
    point[place] = kept;
  }

  /// Deepest first.
  GYRO_HD void sort() {
    for (int i = 1; i < count; ++i) {
      const NearPoint moved = point[i];
      int k = i;
      for (; k > 0 && comes_before(moved, point[k - 1]); --k) point[k] = point[k - 1];
      point[k] = moved;
    }
  }

 private:
  GYRO_HD static bool is_same(const NearPoint& a, const NearPoint& b) {
    const Vec3d between = a.height * a.normal - b.height * b.normal;
    return norm2(between) <= same_point * same_point * (a.height * b.height);
  }
  GYRO_HD int shallowest() const {
    int worst = 0;
    for (int i = 1; i < count; ++i)
      if (comes_before(point[worst], point[i])) worst = i;
    return worst;
  }
};

}  // namespace gyro
