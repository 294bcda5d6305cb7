// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/concave_outline.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

constexpr double edge_margin = 0.1;  // of the lower edge's radius

bool lower(const ProfilePoint& a, const ProfilePoint& b) {
  return a.z < b.z;
}

}  // namespace

ConcaveOutline::ConcaveOutline(std::vector<ProfilePoint> points) : points_(std::move(points)) {
  for (const ProfilePoint& p : points_)
    if (!std::isfinite(p.r) || !std::isfinite(p.z))
      throw BadInput("the concave has a point that is not finite; all must be numbers");
  std::stable_sort(points_.begin(), points_.end(), lower);
  if (points_.empty() || !(edge() < rim())) throw BadInput("the concave has no height; it needs points of two heights");
}

double ConcaveOutline::radius(double z) const {
  if (z < edge()) return (1 + edge_margin) * points_.front().r + edge() - z;
  const auto above = std::upper_bound(points_.begin(), points_.end(), ProfilePoint{0, z}, lower);
  if (above == points_.end()) return points_.back().r;
  const ProfilePoint &a = *(above - 1), &b = *above;
  return a.r + (b.r - a.r) * (z - a.z) / (b.z - a.z);
}

bool ConcaveOutline::outside(const Vec3d& point) const {
  return std::hypot(point.x, point.y) > radius(point.z);
}

}  // namespace gyro
