// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state/walls.hpp"

namespace gyro {

/// Touches of a sphere with a wall of any kind. Body frame in, body frame out.
GYRO_HD inline WallTouches touch_wall(const WallSurface& surface, const SegmentRange& range, const Vec3d& centre,
                                      double radius) {
  if (surface.kind == WallKind::plane) return touch_plane(surface.plane.point, surface.plane.normal, centre, radius);
  if (surface.kind == WallKind::profile) return touch_profile(surface.profile, range, centre, radius);
  return touch_mesh(surface.mesh, centre, radius);
}

/// The same touches, from what the wall list says of an entry: looks only at what may have come within reach since the
/// list was built.
struct ListedTouches {
  const WallClearance* clearance;
  const Index* triangle;  ///< as in WallPairs
  const double* triangle_gap;

  /// @param n  the entry's number
  GYRO_HD WallTouches operator()(Index n, const WallEntry& entry, const WallSurface& surface, const Vec3d& centre,
                                 double radius) const {
    const WallClearance free = clearance[n];
    const double moved2 = norm2(centre - free.centre);
    if (moved2 < free.gap * free.gap) return {};
    if (surface.kind != WallKind::mesh) return touch_wall(surface, entry.range, centre, radius);
    const double* gap = triangle_gap + entry.range.first;
    const Index listed = entry.range.last - entry.range.first;
    Index count = 0;
    while (count < listed && !(moved2 < gap[count] * gap[count])) ++count;
    return touch_triangles(surface.mesh.triangles, triangle + entry.range.first, count, centre, radius);
  }
};

}  // namespace gyro
