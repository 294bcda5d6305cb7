// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surfaces/merge.hpp"

namespace gyro {

/// One straight piece of a profile in the (r, z) half-plane. Rock is on the left of the direction.
struct ProfileSegment {
  double r, z;                      ///< begin [m]
  double direction_r, direction_z;  ///< unit
  double length;                    ///< [m]
};

/// Segments [first, last) of a profile.
struct SegmentRange {
  Index first, last;
};
template <>
struct RowOf<SegmentRange> : MadeOf<Index> {};

/// A surface of revolution as kernels see it. The arrays belong to a ProfileSurface or its copy.
struct ProfileView {
  const ProfileSegment* segments;
  Index count;
  const SegmentRange* bins;  ///< segments that reach into each slice of height
  Index bin_count;
  double z_begin, bin_height;  ///< of the lowest slice [m]
};

/// A point in the half-plane of a body of revolution.
struct SectionPoint {
  double r, z;
};

/// Distance along and to the left of a segment's line, from its begin [m].
struct AlongLeft {
  double along, left;
};

GYRO_HD inline AlongLeft relative_to(const ProfileSegment& s, const SectionPoint& p) {
  const double r = p.r - s.r, z = p.z - s.z;
  return {r * s.direction_r + z * s.direction_z, z * s.direction_r - r * s.direction_z};
}

/// Square of the distance of a point to a segment [m2].
GYRO_HD inline double distance2(const ProfileSegment& s, const SectionPoint& p) {
  const AlongLeft q = relative_to(s, p);
  const double beyond = q.along < 0 ? q.along : q.along > s.length ? q.along - s.length : 0;
  return beyond * beyond + q.left * q.left;
}

/// The shortest range of segments that holds all within `reach` of a point of the body frame;
/// empty (first == last) when there is none. Ask with the sphere's radius plus a margin when
/// neighbour lists are built, and keep the range until the next time.
GYRO_HD inline SegmentRange segments_near(const ProfileView& profile, const Vec3d& centre, double reach) {
  const double top = profile.z_begin + profile.bin_count * profile.bin_height;
  if (!(centre.z + reach >= profile.z_begin && centre.z - reach <= top)) return {0, 0};
  const double scale = 1 / profile.bin_height;
  double low = (centre.z - reach - profile.z_begin) * scale, high = (centre.z + reach - profile.z_begin) * scale;
  low = low > 0 ? low : 0;
  high = high < profile.bin_count - 1 ? high : profile.bin_count - 1;
  SegmentRange range{profile.count, 0};
  for (Index bin = static_cast<Index>(low); bin <= static_cast<Index>(high); ++bin) {
    if (profile.bins[bin].first < range.first) range.first = profile.bins[bin].first;
    if (profile.bins[bin].last > range.last) range.last = profile.bins[bin].last;
  }
  const SectionPoint p{::sqrt(centre.x * centre.x + centre.y * centre.y), centre.z};
  while (range.first < range.last && distance2(profile.segments[range.first], p) > reach * reach) ++range.first;
  while (range.first < range.last && distance2(profile.segments[range.last - 1], p) > reach * reach) --range.last;
  return range.first < range.last ? range : SegmentRange{0, 0};
}

/// A closest point in the half-plane: unit normal and signed height, negative behind the surface.
struct SectionTouch {
  double normal_r, normal_z, height;
  Place place;
};

/// Corner at the begin of segment k (the end of the last one for k == count), for a point beyond
/// both neighbours. The sign tells front from back; free ends have no back.
GYRO_HD inline SectionTouch corner_touch(const ProfileView& profile, Index k, const SectionPoint& p) {
  const ProfileSegment& last = profile.segments[profile.count - 1];
  const double r0 = k < profile.count ? profile.segments[k].r : last.r + last.length * last.direction_r;
  const double z0 = k < profile.count ? profile.segments[k].z : last.z + last.length * last.direction_z;
  const double r = p.r - r0, z = p.z - z0;
  double height = ::sqrt(r * r + z * z);
  const ProfileSegment& after = profile.segments[k < profile.count ? k : profile.count - 1];
  if (!(height > 0)) return {-after.direction_z, after.direction_r, 0, Place::rim};
  if (k > 0 && k < profile.count) {
    const ProfileSegment& before = profile.segments[k - 1];
    const double left = z * (before.direction_r + after.direction_r) - r * (before.direction_z + after.direction_z);
    if (left < 0) height = -height;
  }
  return {r / height, z / height, height, Place::rim};
}

/// The half-plane through the axis and a sphere's centre. On the axis that of +x is taken.
struct Section {
  SectionPoint centre;
  Vec3d outward;  ///< unit, away from the axis

  GYRO_HD explicit Section(const Vec3d& c) : centre{::sqrt(c.x * c.x + c.y * c.y), c.z}, outward{1, 0, 0} {
    if (centre.r > 0) outward = {c.x / centre.r, c.y / centre.r, 0};
  }
  GYRO_HD NearPoint in_space(const SectionTouch& t) const {
    return {{t.normal_r * outward.x, t.normal_r * outward.y, t.normal_z}, t.height};
  }
};

/// The closest points of a range of segments, fronts and backs.
struct PointsOfProfile {
  const ProfileView& profile;
  SegmentRange range;
  const Section& section;

  template <class Visit>
  GYRO_HD void operator()(Visit& visit) const {
    const SectionPoint& p = section.centre;
    bool beyond_last = range.first == 0 || relative_to(profile.segments[range.first - 1], p).along >=
                                               profile.segments[range.first - 1].length;
    for (Index k = range.first; k < range.last; ++k) {
      const ProfileSegment& s = profile.segments[k];
      const AlongLeft q = relative_to(s, p);
      if (q.along > 0 && q.along < s.length)
        visit(SectionTouch{-s.direction_z, s.direction_r, q.left, Place::inside});
      else if (q.along <= 0 && beyond_last)
        visit(corner_touch(profile, k, p));
      beyond_last = q.along >= s.length;
    }
    if (range.last == profile.count && range.first < range.last && beyond_last)
      visit(corner_touch(profile, profile.count, p));
  }
};

/// Visitor that offers the fronts nearer than the radius to a finder, and keeps the nearest back.
struct OfferFront {
  const Section& section;
  double radius;
  FindDeepest& finder;
  SectionTouch back;  ///< height -radius: none
  int fronts = 0;

  GYRO_HD void operator()(const SectionTouch& t) {
    if (t.height >= radius) return;
    if (t.height < 0) {
      if (t.height > back.height) back = t;
      return;
    }
    ++fronts;
    offer(t);
  }
  GYRO_HD void offer(const SectionTouch& t) {
    const NearPoint p = section.in_space(t);
    if (finder.wants(p, t.place)) finder.take(p, t.place);
  }
};

/// The fronts that a sphere overlaps; when there are none, the nearest back with its height below
/// 0: the normal does not flip when the centre passes through the surface.
struct FrontsOfProfile {
  PointsOfProfile points;
  double radius;

  GYRO_HD void operator()(FindDeepest& finder) const {
    OfferFront fronts{points.section, radius, finder, {0, 0, -radius, Place::out_of_reach}};
    points(fronts);
    if (fronts.fronts == 0 && fronts.back.height > -radius) fronts.offer(fronts.back);
  }
};

/// Touches of a sphere with a surface of revolution, in the body frame.
///
/// The closest points of the surface lie in the half-plane through the axis and the centre (for a
/// sphere smaller than the surface's own radius there), so that the curvature around the axis is
/// exact.
///
/// @param range   segments to look at, from segments_near()
/// @param centre  of the sphere [m], body frame
/// @param radius  of the sphere [m]
/// @return normals in the body frame
GYRO_HD inline WallTouches touch_profile(const ProfileView& profile, const SegmentRange& range, const Vec3d& centre,
                                         double radius) {
  const Section section(centre);
  return merged_touches(visible_points(FrontsOfProfile{{profile, range, section}, radius}), radius);
}

}  // namespace gyro
