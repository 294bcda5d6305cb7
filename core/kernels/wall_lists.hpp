// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/wall_motion.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Finds the walls that each particle is near to.
template <class Real>
struct FindWalls {
  ParticleView p;
  const WallSurface* surfaces;
  const WallPose* poses;
  Index wall_count;
  double skin;
  Index* counts;       ///< counting run: walls of each particle; filling run: first entry of each
  WallEntry* entries;  ///< null in the counting run

  GYRO_HD void operator()(Index n) const {
    const Sphere sphere = p.position[n];
    Index found = 0;
    for (Index w = 0; w < wall_count; ++w) {
      const Vec3d centre = to_body(poses[w], sphere.x);
      SegmentRange range{0, 0};
      if (!near(surfaces[w], centre, sphere.radius + skin, range)) continue;
      if (entries != nullptr) entries[counts[n] + found] = {n, w, range};
      ++found;
    }
    if (entries == nullptr) counts[n] = found;
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

/// Brings the memory of touching wall contacts over from the old lists.
template <class Real>
struct CarryWallHistory {
  WallView<Real> now, old;

  GYRO_HD void operator()(Index n) const {
    const WallEntry entry = now.entries[n];
    now.history[n].count = 0;
    now.touching[n] = 0;
    now.sums[n] = WallSum{};
    for (Index e = old.row_begin[entry.particle]; e < old.row_begin[entry.particle + 1]; ++e) {
      if (old.entries[e].wall != entry.wall) continue;
      now.history[n] = old.history[e];
      now.touching[n] = old.touching[e];
      return;
    }
  }
};

}  // namespace gyro
