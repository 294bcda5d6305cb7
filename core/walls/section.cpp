// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/section.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

double distance_to_piece(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  const double dr = b.r - a.r, dz = b.z - a.z;
  const double t = std::clamp(((p.r - a.r) * dr + (p.z - a.z) * dz) / (dr * dr + dz * dz), 0.0, 1.0);
  return std::hypot(p.r - a.r - t * dr, p.z - a.z - t * dz);
}

/// Distance of a point from a piece along z only, a lower bound.
double height_above_piece(const ProfilePoint& p, const ProfilePoint& a, const ProfilePoint& b) {
  return std::max(std::min(a.z, b.z) - p.z, p.z - std::max(a.z, b.z));
}

double distance_to_line(const Polyline& points, const Polyline& line) {
  constexpr double rounding = 1 + 1e-9;
  double minimum = std::numeric_limits<double>::infinity();
  for (const ProfilePoint& p : points)
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      if (height_above_piece(p, line[i], line[i + 1]) > rounding * minimum) continue;
      minimum = std::min(minimum, distance_to_piece(p, line[i], line[i + 1]));
    }
  return minimum;
}

/// Twice the area of the triangle a, b, c; positive if c is on the left of a to b.
double twice_area(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c) {
  return (b.r - a.r) * (c.z - a.z) - (b.z - a.z) * (c.r - a.r);
}

}  // namespace

Polyline below(const Polyline& line, double z) {
  Polyline part;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i].z > z) {
      if (i > 0) {
        const double t = (z - line[i - 1].z) / (line[i].z - line[i - 1].z);
        part.push_back({line[i - 1].r + t * (line[i].r - line[i - 1].r), z});
      }
      break;
    }
    part.push_back(line[i]);
  }
  return part;
}

double distance_between(const Polyline& a, const Polyline& b) {
  // The shortest distance of segments that do not cross is at an end of one of them.
  return std::min(distance_to_line(a, b), distance_to_line(b, a));
}

bool cross_each_other(const Polyline& a, const Polyline& b) {
  for (std::size_t i = 0; i + 1 < a.size(); ++i)
    for (std::size_t k = 0; k + 1 < b.size(); ++k)
      if (twice_area(a[i], a[i + 1], b[k]) * twice_area(a[i], a[i + 1], b[k + 1]) <= 0 &&
          twice_area(b[k], b[k + 1], a[i]) * twice_area(b[k], b[k + 1], a[i + 1]) <= 0)
        return true;
  return false;
}

}  // namespace gyro
