// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Contact geometry of a sphere and a wall, in the wall's body frame: plane here, surface of
// revolution and triangles in the files included.
#include "core/surfaces/mesh.hpp"
#include "core/surfaces/profile.hpp"

namespace gyro {

/// Touch of a sphere with an infinite plane. The normal stays the plane's when the centre is behind it.
/// @param point, normal  of the plane; the normal is unit and points to the rock
GYRO_HD inline WallTouches touch_plane(const Vec3d& point, const Vec3d& normal, const Vec3d& centre, double radius) {
  WallTouches result;
  const double gap = dot(centre - point, normal) - radius;
  if (gap < 0) {
    result.touch[0] = {normal, gap, 1};
    result.count = 1;
  }
  return result;
}

}  // namespace gyro
