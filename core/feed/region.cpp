// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/region.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

constexpr int slices = 512;

/// A piece of surface: a triangle, or a profile's segment drawn in the half-plane y = 0.
struct Piece {
  std::array<Vec3d, 3> corner;
  int corners;
};

std::vector<Piece> pieces_of(const Wall& wall) {
  std::vector<Piece> pieces;
  if (const auto* profile = std::get_if<ProfileShape>(&wall.shape)) {
    for (std::size_t k = 1; k < profile->points.size(); ++k) {
      const ProfilePoint a = profile->points[k - 1], b = profile->points[k];
      pieces.push_back({{Vec3d{a.r, 0, a.z}, Vec3d{b.r, 0, b.z}, Vec3d{}}, 2});
    }
  } else if (const auto* mesh = std::get_if<TriangleMesh>(&wall.shape)) {
    for (const auto& t : mesh->triangles) {
      const auto at = [&](Index v) { return mesh->vertices[static_cast<std::size_t>(v)]; };
      pieces.push_back({{at(t.x), at(t.y), at(t.z)}, 3});
    }
  }
  if (pieces.empty()) {
    throw BadInput("wall \"" + wall.name + "\" has no radius about the z axis; it must be a profile or a mesh");
  }
  return pieces;
}

struct Range {
  double low, high;
};

Range heights_of(const std::vector<Piece>& pieces) {
  Range r{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Piece& p : pieces) {
    for (int k = 0; k < p.corners; ++k) {
      r.low = std::min(r.low, p.corner[static_cast<std::size_t>(k)].z);
      r.high = std::max(r.high, p.corner[static_cast<std::size_t>(k)].z);
    }
  }
  return r;
}

/// Corners of the part of a piece inside a slice of height (Sutherland & Hodgman 1974).
std::vector<Vec3d> clipped(const Piece& piece, const Range& slice) {
  std::vector<Vec3d> polygon(piece.corner.begin(), piece.corner.begin() + piece.corners);
  for (const double sign : {1.0, -1.0}) {
    const double level = sign > 0 ? slice.low : slice.high;
    std::vector<Vec3d> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec3d& a = polygon[k];
      const Vec3d& b = polygon[(k + 1) % polygon.size()];
      const double da = sign * (a.z - level), db = sign * (b.z - level);
      if (da >= 0) kept.push_back(a);
      if ((da > 0 && db < 0) || (da < 0 && db > 0)) kept.push_back(a + da / (da - db) * (b - a));
    }
    polygon = std::move(kept);
  }
  return polygon;
}

/// Smallest and largest distance of a polygon to the z axis.
Range radii_of(const std::vector<Vec3d>& polygon) {
  Range r{std::numeric_limits<double>::infinity(), 0};
  bool left = false, right = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec3d &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    const double ex = b.x - a.x, ey = b.y - a.y, length2 = ex * ex + ey * ey;
    const double t = length2 > 0 ? std::clamp(-(a.x * ex + a.y * ey) / length2, 0.0, 1.0) : 0.0;
    r.low = std::min(r.low, std::hypot(a.x + t * ex, a.y + t * ey));
    r.high = std::max(r.high, std::hypot(a.x, a.y));
    const double twice_area = a.x * b.y - a.y * b.x, rounding = 1e-12 * (r.high * r.high);
    left = left || twice_area > rounding;
    right = right || twice_area < -rounding;
  }
  if (left != right) r.low = 0;  // the axis passes through it
  return r;
}

}  // namespace

RadiusByHeight::RadiusByHeight(const Wall& wall, Side side) : side_(side) {
  const std::vector<Piece> pieces = pieces_of(wall);
  const Range heights = heights_of(pieces);
  low_ = heights.low;
  high_ = heights.high;
  const bool outer = side == Side::outer;
  radius_.assign(slices, outer ? std::numeric_limits<double>::infinity() : 0.0);
  const double step = (high_ - low_) / slices;
  for (const Piece& piece : pieces) {
    const Range span = heights_of({piece});
    const auto slice_of = [&](double z) {
      return step > 0 ? std::clamp(static_cast<int>((z - low_) / step), 0, slices - 1) : 0;
    };
    for (int k = slice_of(span.low); k <= slice_of(span.high); ++k) {
      const std::vector<Vec3d> part = clipped(piece, {low_ + k * step, low_ + (k + 1) * step});
      if (part.empty()) continue;
      const Range r = radii_of(part);
      double& kept = radius_[static_cast<std::size_t>(k)];
      kept = outer ? std::min(kept, r.low) : std::max(kept, r.high);
    }
  }
  // A slice in which the mesh has no triangles gets the radius below it, or at the foot the radius above it.
  const auto known = [](double r) { return r < std::numeric_limits<double>::infinity(); };
  double last = *std::find_if(radius_.begin(), radius_.end(), known);
  for (double& r : radius_) last = r = known(r) ? r : last;
}

double RadiusByHeight::at(double z) const {
  if (side_ == Side::inner && z > high_) return 0;
  const double slice = high_ > low_ ? (z - low_) / (high_ - low_) * slices : 0;
  return radius_[static_cast<std::size_t>(std::clamp(slice, 0.0, slices - 1.0))];
}

CylinderRegion opening_above(const Wall& wall, double height) {
  const RadiusByHeight outer(wall, RadiusByHeight::Side::outer);
  return {{0, 0, outer.high()}, outer.at(outer.high()), height};
}

}  // namespace gyro
