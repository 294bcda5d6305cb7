// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/wall_distance.hpp"

#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

Vec3d lower(const Vec3d& a, const Vec3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3d upper(const Vec3d& a, const Vec3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace

WallDistance::WallDistance(const Wall& wall, double reach) : reach_(reach) {
  if (const auto* plane = std::get_if<PlaneShape>(&wall.shape)) plane_ = *plane;
  if (const auto* profile = std::get_if<ProfileShape>(&wall.shape)) make_profile(*profile);
  if (const auto* mesh = std::get_if<TriangleMesh>(&wall.shape)) make_mesh(*mesh);
}

void WallDistance::make_profile(const ProfileShape& shape) {
  for (std::size_t k = 1; k < shape.points.size(); ++k) {
    const ProfilePoint a = shape.points[k - 1], b = shape.points[k];
    const double dr = b.r - a.r, dz = b.z - a.z;
    segments_.push_back({a.r, a.z, dr, dz, dr * dr + dz * dz, std::min(a.z, b.z), std::max(a.z, b.z)});
  }
  if (!segments_.empty()) fill_slices();
}

/// Lists the segments by height. Slices overlap a little, so that rounding of a slice's number loses none.
void WallDistance::fill_slices() {
  constexpr int count = 256;
  double low = segments_[0].low, high = segments_[0].high;
  for (const Segment& s : segments_) {
    low = std::min(low, s.low);
    high = std::max(high, s.high);
  }
  const double margin = 1.01 * reach_, height = high - low + 2 * margin, slice = height / count, overlap = 0.01 * slice;
  slices_.low = low - margin;
  slices_.per_metre = count / height;
  slices_.begin.assign(1, 0);
  for (int n = 0; n < count; ++n) {
    const double foot = slices_.low + n * slice - overlap, top = slices_.low + (n + 1) * slice + overlap;
    for (std::size_t k = 0; k < segments_.size(); ++k)
      if (segments_[k].high >= foot - reach_ && segments_[k].low <= top + reach_)
        slices_.segment.push_back(static_cast<Index>(k));
    slices_.begin.push_back(static_cast<Index>(slices_.segment.size()));
  }
}

void WallDistance::make_mesh(const TriangleMesh& shape) {
  for (const auto& t : shape.triangles) {
    const auto at = [&](Index v) { return shape.vertices[static_cast<std::size_t>(v)]; };
    const Vec3d a = at(t.x), b = at(t.y), c = at(t.z), n = cross(b - a, c - a);
    if (norm2(n) > 0) triangles_.push_back({a, b, c, (1 / norm(n)) * n});
  }
  if (!triangles_.empty()) fill_cells();
}

/// Makes a grid over the mesh. Each cell lists the triangles that may be within reach.
void WallDistance::fill_cells() {
  Vec3d low = triangles_[0].a, high = low;
  for (const FlatTriangle& t : triangles_) {
    low = lower(low, lower(t.a, lower(t.b, t.c)));
    high = upper(high, upper(t.a, upper(t.b, t.c)));
  }
  const Vec3d margin{reach_, reach_, reach_}, size = high - low + 2.0 * margin;
  cells_.low = low - margin;
  cells_.size = std::max(reach_, std::max(size.x, std::max(size.y, size.z)) / 64);
  const auto cells_along = [&](double length) { return static_cast<Index>(length / cells_.size) + 1; };
  cells_.count = {cells_along(size.x), cells_along(size.y), cells_along(size.z)};
  const auto n = static_cast<std::size_t>(cells_.count.x) * static_cast<std::size_t>(cells_.count.y * cells_.count.z);

  const auto for_cells_of = [&](const FlatTriangle& t, const auto& visit) {
    const Vec3d a = (1 / cells_.size) * (lower(t.a, lower(t.b, t.c)) - margin - cells_.low);
    const Vec3d b = (1 / cells_.size) * (upper(t.a, upper(t.b, t.c)) + margin - cells_.low);
    for (Index z = static_cast<Index>(std::max(a.z, 0.0)); z <= std::min(static_cast<Index>(b.z), cells_.count.z - 1);
         ++z)
      for (Index y = static_cast<Index>(std::max(a.y, 0.0)); y <= std::min(static_cast<Index>(b.y), cells_.count.y - 1);
           ++y)
        for (Index x = static_cast<Index>(std::max(a.x, 0.0));
             x <= std::min(static_cast<Index>(b.x), cells_.count.x - 1); ++x)
          visit(static_cast<std::size_t>((z * cells_.count.y + y) * cells_.count.x + x));
  };
  cells_.begin.assign(n + 1, 0);
  for (const FlatTriangle& t : triangles_) for_cells_of(t, [&](std::size_t cell) { ++cells_.begin[cell + 1]; });
  for (std::size_t cell = 0; cell < n; ++cell) cells_.begin[cell + 1] += cells_.begin[cell];
  cells_.triangle.resize(static_cast<std::size_t>(cells_.begin[n]));
  std::vector<Index> next(cells_.begin.begin(), cells_.begin.end() - 1);
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    for_cells_of(triangles_[k], [&](std::size_t cell) {
      cells_.triangle[static_cast<std::size_t>(next[cell]++)] = static_cast<Index>(k);
    });
  }
}

double WallDistance::at(const WallPose& pose, const Vec3d& point) const {
  const Vec3d body = to_body(pose, point);
  if (!segments_.empty()) return to_profile(body);
  if (!triangles_.empty()) return to_mesh(body);
  return std::clamp(dot(body - plane_.point, plane_.normal), -reach_, reach_);
}

double WallDistance::to_profile(const Vec3d& body) const {
  const double z = body.z, at = (z - slices_.low) * slices_.per_metre;
  const auto count = static_cast<double>(slices_.begin.size() - 1);
  if (!(at >= 0 && at < count)) return std::sqrt(reach_ * reach_);  // the bits of a wall out of reach, as below
  const double r = std::sqrt(body.x * body.x + body.y * body.y);
  double nearest2 = reach_ * reach_;
  double crossing = std::numeric_limits<double>::infinity();  // horizontal distance to the surface
  bool behind = false;
  const auto slice = static_cast<std::size_t>(at);
  for (Index k = slices_.begin[slice]; k < slices_.begin[slice + 1]; ++k) {
    const Segment& s = segments_[static_cast<std::size_t>(slices_.segment[static_cast<std::size_t>(k)])];
    if (s.low <= z && z < s.high) {
      // The segment nearest along the horizontal decides the side: rock is left of the direction of travel.
      const double way = s.r + (z - s.z) / s.dz * s.dr - r;
      if (std::abs(way) < crossing) {
        crossing = std::abs(way);
        behind = s.dz > 0 ? way < 0 : way > 0;
      }
    }
    if (s.high < z - reach_ || s.low > z + reach_) continue;
    const double t = std::clamp(((r - s.r) * s.dr + (z - s.z) * s.dz) / s.length2, 0.0, 1.0);
    const double or_ = r - s.r - t * s.dr, oz = z - s.z - t * s.dz;
    nearest2 = std::min(nearest2, or_ * or_ + oz * oz);
  }
  const double nearest = std::sqrt(nearest2);
  return behind ? -nearest : nearest;
}

double WallDistance::to_mesh(const Vec3d& body) const {
  const Vec3d p = (1 / cells_.size) * (body - cells_.low);  // in cells
  if (!(p.x >= 0 && p.y >= 0 && p.z >= 0)) return reach_;
  if (!(p.x < cells_.count.x && p.y < cells_.count.y && p.z < cells_.count.z)) return reach_;
  const Vec3<Index> c{static_cast<Index>(p.x), static_cast<Index>(p.y), static_cast<Index>(p.z)};
  const auto cell = static_cast<std::size_t>((c.z * cells_.count.y + c.y) * cells_.count.x + c.x);
  double nearest2 = reach_ * reach_;
  for (Index k = cells_.begin[cell]; k < cells_.begin[cell + 1]; ++k) {
    const auto triangle = static_cast<std::size_t>(cells_.triangle[static_cast<std::size_t>(k)]);
    nearest2 = std::min(nearest2, distance2_to_triangle(triangles_[triangle], body));
  }
  return std::sqrt(nearest2);
}

}  // namespace gyro
