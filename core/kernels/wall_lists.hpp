// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/row_filler.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Finds the walls that each particle is near to.
struct FindWalls {
  ConstParticleView p;
  WallsNow walls;
  double skin;
  RowFiller<WallEntry> rows;

  GYRO_HD void operator()(Index n) const {
    const Sphere sphere = p.position[n];
    Index found = 0;
    for (Index w = 0; w < walls.count; ++w) {
      const Vec3d centre = to_body(walls.poses[w], sphere.x);
      SegmentRange range{0, 0};
      if (near(walls.surfaces[w], centre, sphere.radius + skin, range)) rows.add(n, found, {n, w, range});
    }
    rows.end_row(n, found);
  }

 private:
  GYRO_HD static bool near(const WallSurface& s, const Vec3d& centre, double reach, SegmentRange& range) {
    if (s.kind == WallKind::plane) return dot(centre - s.plane.point, s.plane.normal) < reach;
    if (s.kind == WallKind::profile) {
      range = segments_near(s.profile, centre, reach);
      return range.first < range.last;
    }
    Index first;
    return triangles_near(s.mesh, centre, reach, &first, 1) > 0;
  }
};

/// Carries the history of touching wall contacts over from the old list.
template <class Real>
struct CarryWallHistory {
  WallPairView<Real> now;
  ConstWallPairView<Real> old;
  bool with_extra;  ///< the contact law keeps ExtraHistory

  GYRO_HD void operator()(Index n) const {
    const WallEntry entry = now.entry[n];
    now.history[n].count = 0;
    now.touching[n] = 0;
    for (Index e = old.row_begin[entry.particle]; e < old.row_begin[entry.particle + 1]; ++e) {
      if (old.entry[e].wall != entry.wall) continue;
      now.history[n] = old.history[e];
      if (with_extra) now.extra[n] = old.extra[e];
      now.touching[n] = old.touching[e];
      return;
    }
  }
};

}  // namespace gyro
