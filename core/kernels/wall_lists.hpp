// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/row_filler.hpp"
#include "core/math/select.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Finds the walls that each particle may touch while it stays in its bound.
struct FindWalls {
  const Sphere* bounds;
  WallsNow walls;
  const double* ways;  ///< that each wall may move meanwhile [m]
  RowFiller<WallEntry> rows;

  GYRO_HD void operator()(Index n) const {
    const Sphere bound = bounds[n];
    Index found = 0;
    for (Index w = 0; w < walls.count && !rows.is_full(n, found); ++w) {
      const Vec3d centre = to_body(walls.poses[w], bound.x);
      SegmentRange range{0, 0};
      if (near(walls.surfaces[w], centre, bound.radius + ways[w], range)) rows.add(n, found, {n, w, range});
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
    AnyNear any{s.mesh.triangles, centre, reach};
    visit_near(s.mesh, centre, reach, any);
    return any.found;
  }
};

/// Visitor that lists the triangles within reach, the nearest first and each once.
struct ListNearest {
  const WallTriangle* triangles;
  Vec3d centre;
  double radius, reach;
  double rounding;  ///< of a distance [m]
  Index* ids;       ///< null: only counts, and some more than once
  double* gaps;
  Index count = 0;

  GYRO_HD void operator()(Index id) {
    NearPoint point;
    if (near_triangle(triangles[id], centre, reach, point) == Place::out_of_reach) return;
    if (ids != nullptr) {
      const double gap = positive(point.height - radius - rounding);
      Index place = count;
      while (place > 0 && comes_before(gap, id, place - 1)) --place;
      if (place > 0 && ids[place - 1] == id) return;
      for (Index i = count; i > place; --i) {
        ids[i] = ids[i - 1];
        gaps[i] = gaps[i - 1];
      }
      ids[place] = id;
      gaps[place] = gap;
    }
    ++count;
  }
  /// Of two that are equally near the one with the lower number comes first.
  GYRO_HD bool comes_before(double gap, Index id, Index place) const {
    return gap < gaps[place] || (gap == gaps[place] && id < ids[place]);
  }
};

/// Measures what is free between the particles and walls of the list, and lists the triangles that each may touch until
/// the next rebuild. Runs twice, as RowFiller: the first run counts the triangles.
struct MeasureWalls {
  ConstParticleView p;
  WallsNow walls;
  const Sphere* bounds;
  const double* ways;  ///< as in FindWalls [m]
  WallEntry* entry;
  WallClearance* clearance;
  Index* begin;  ///< of the entry's triangles; counting run: how many, at least
  Index* triangle = nullptr;
  double* triangle_gap = nullptr;

  GYRO_HD void operator()(Index n) const {
    const WallSurface& wall = walls.surfaces[entry[n].wall];
    const Sphere bound = bounds[entry[n].particle];
    const double radius = p.position[entry[n].particle].radius, reach = bound.radius + ways[entry[n].wall];
    const Vec3d centre = to_body(walls.poses[entry[n].wall], bound.x);
    const bool counts = triangle == nullptr;
    // Planes of triangles are known to 1e-7 rad (mesh_grid.cpp), both here and when a distance is computed again.
    const double rounding = 4e-7 * wall.extent;
    double gap = 0;
    Index triangles = 0;
    if (wall.kind == WallKind::mesh) {
      ListNearest list{wall.mesh.triangles, centre, radius, reach, rounding, nullptr, nullptr};
      if (!counts) {
        list.ids = triangle + begin[n];
        list.gaps = triangle_gap + begin[n];
      }
      visit_near(wall.mesh, centre, reach, list);
      triangles = list.count;
      if (!counts) {
        entry[n].range = {begin[n], begin[n] + triangles};
        gap = triangles > 0 ? list.gaps[0] : 0;
      }
    } else if (wall.kind == WallKind::profile) {
      gap = profile_gap(wall.profile, entry[n].range, centre, reach) - radius - rounding;
    }
    if (counts)
      begin[n] = triangles;
    else
      clearance[n] = {centre, positive(gap)};
  }

 private:
  /// Distance of a centre from the nearest of a range of segments, or `reach` if that is less [m].
  GYRO_HD static double profile_gap(const ProfileView& profile, const SegmentRange& range, const Vec3d& centre,
                                    double reach) {
    double nearest2 = reach * reach;
    const SectionPoint point{::sqrt(centre.x * centre.x + centre.y * centre.y), centre.z};
    for (Index k = range.first; k < range.last; ++k)
      nearest2 = smaller(nearest2, distance2(profile.segments[k], point));
    return ::sqrt(nearest2);
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
