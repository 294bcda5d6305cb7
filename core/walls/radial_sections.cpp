// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/radial_sections.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace gyro {
namespace {

constexpr double no_surface = std::numeric_limits<double>::quiet_NaN();

}  // namespace

RadialSections::RadialSections(const TriangleMesh& mesh, double lift, const HeightRange& heights, Face face)
    : heights_(heights), radius_(static_cast<std::size_t>(azimuths * levels), no_surface) {
  std::vector<Vec3d> across;  // horizontal normals of the half-planes, to the left
  for (int a = 0; a < azimuths; ++a) {
    const double angle = 2 * std::numbers::pi * a / azimuths;
    across.push_back({-std::sin(angle), std::cos(angle), 0});
  }
  for (const Vec3<Index>& t : mesh.triangles) {
    Vec3d corner[3];
    const Index corners[3] = {t.x, t.y, t.z};
    for (int k = 0; k < 3; ++k) corner[k] = mesh.vertices[static_cast<std::size_t>(corners[k])] + Vec3d{0, 0, lift};
    if (std::max({corner[0].z, corner[1].z, corner[2].z}) < heights_.low - 1e-9 ||
        std::min({corner[0].z, corner[1].z, corner[2].z}) > heights_.high + 1e-9)
      continue;
    for (int a = 0; a < azimuths; ++a) cut(corner, a, across[static_cast<std::size_t>(a)], face);
  }
  int bridges = 0;
  for (int a = 0; a < azimuths; ++a) bridges += bridge(a);
  bridged_ = double(bridges) / (azimuths * levels);
}

void RadialSections::cut(const Vec3d* corner, int azimuth, const Vec3d& across, Face face) {
  Point ends[2];
  int found = 0;
  for (int k = 0; k < 3; ++k) {  // corners on the plane count as left of it, so that either two edges cross it or none
    const Vec3d &p = corner[k], &q = corner[(k + 1) % 3];
    const double dp = dot(across, p), dq = dot(across, q);
    if ((dp >= 0) == (dq >= 0)) continue;
    const Vec3d on = p + dp / (dp - dq) * (q - p);
    ends[found++] = {across.y * on.x - across.x * on.y, on.z};
  }
  if (found == 2) add_segment(azimuth, ends[0], ends[1], face);
}

void RadialSections::add_segment(int azimuth, const Point& a, const Point& b, Face face) {
  const double step = (heights_.high - heights_.low) / (levels - 1), rounding = 1e-9;
  const double bottom = std::min(a.z, b.z) - rounding, top = std::max(a.z, b.z) + rounding;
  const int first = std::max(0, static_cast<int>(std::ceil((bottom - heights_.low) / step)));
  const int last = std::min(levels - 1, static_cast<int>(std::floor((top - heights_.low) / step)));
  const auto keep = [&](int k, double r) {
    double& kept = radius(azimuth, k);
    if (r > 0 && !(face == Face::innermost ? kept <= r : kept >= r)) kept = r;
  };
  for (int k = first; k <= last; ++k) {
    if (std::abs(b.z - a.z) <= rounding) {
      keep(k, a.r);
      keep(k, b.r);
    } else {
      keep(k, std::lerp(a.r, b.r, std::clamp((level(k) - a.z) / (b.z - a.z), 0.0, 1.0)));
    }
  }
}

int RadialSections::bridge(int azimuth) {
  int known = -1, bridges = 0;
  for (int k = 0; k < levels; ++k) {
    if (std::isnan(radius(azimuth, k))) continue;
    for (int gap = known + 1; gap < k; ++gap, ++bridges)
      radius(azimuth, gap) =
          known < 0 ? radius(azimuth, k)
                    : std::lerp(radius(azimuth, known), radius(azimuth, k), double(gap - known) / (k - known));
    known = k;
  }
  if (known < 0)
    throw BadInput("a liner has no surface at azimuth " + std::to_string(360.0 * azimuth / azimuths) +
                   " degrees; a liner must surround the axis");
  for (int gap = known + 1; gap < levels; ++gap, ++bridges) radius(azimuth, gap) = radius(azimuth, known);
  return bridges;
}

double RadialSections::at(int azimuth, double z) const {
  const double position = std::clamp((z - heights_.low) / (heights_.high - heights_.low), 0.0, 1.0) * (levels - 1);
  const int k = std::min(static_cast<int>(position), levels - 2);
  const double* row = &radius_[static_cast<std::size_t>(azimuth * levels)];
  return std::lerp(row[k], row[k + 1], position - k);
}

}  // namespace gyro
