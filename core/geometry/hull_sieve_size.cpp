// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sieve_size.hpp"

#include "core/geometry/hull.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyro {
namespace {

constexpr double golden_angle = std::numbers::pi * (3 - 2.23606797749979);  // 3 - sqrt 5

/// Side of the square around plane points (x, y), rotated by the angle.
double square_side(const std::vector<Vec3d>& shadow, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  double low_u = std::numeric_limits<double>::max(), high_u = -low_u, low_v = low_u, high_v = -low_u;
  for (const Vec3d& p : shadow) {
    const double u = c * p.x + s * p.y, v = c * p.y - s * p.x;
    low_u = std::min(low_u, u), high_u = std::max(high_u, u);
    low_v = std::min(low_v, v), high_v = std::max(high_v, v);
  }
  return std::max(high_u - low_u, high_v - low_v);
}

struct Frame {
  Vec3d u, v;
};

/// Two unit vectors across a unit direction.
Frame across(const Vec3d& d) {
  const Vec3d helper = std::abs(d.x) < 0.6 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  const Vec3d u = cross(d, helper), unit = (1 / norm(u)) * u;
  return {unit, cross(d, unit)};
}

/// Unit vector at the height z, the k-th of a spiral that covers the sphere evenly.
Vec3d spread_direction(double z, int k) {
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(k * golden_angle), r * std::sin(k * golden_angle), z};
}

/// Thins out many hull vertices: keeps those that are outermost in one of 1000 directions, enough to find the passage.
std::vector<Vec3d> outermost(const std::vector<Vec3d>& hull) {
  constexpr std::size_t few = 1000;
  if (hull.size() <= few) return hull;
  std::vector<bool> kept(hull.size(), false);
  for (int k = 0; k < static_cast<int>(few); ++k) {
    const Vec3d d = spread_direction(1 - (2 * k + 1.0) / few, k);
    const auto further = [&](const Vec3d& a, const Vec3d& b) { return dot(a, d) < dot(b, d); };
    kept[std::max_element(hull.begin(), hull.end(), further) - hull.begin()] = true;
  }
  std::vector<Vec3d> points;
  for (std::size_t v = 0; v < hull.size(); ++v) {
    if (kept[v]) points.push_back(hull[v]);
  }
  return points;
}

struct Passage {
  Vec3d direction;
  double side;
};

/// Pattern search over directions: moves to a better neighbour while there is one, then halves the step.
Passage refined(const std::vector<Vec3d>& points, Passage best) {
  for (double step = 0.08; step > 1e-4; step /= 2) {
    for (bool better = true; better;) {
      better = false;
      const Frame frame = across(best.direction);
      for (const Vec3d& move : {frame.u, -frame.u, frame.v, -frame.v}) {
        const Vec3d d = best.direction + step * move, unit = (1 / norm(d)) * d;
        const double side = shadow_square(points, unit);
        if (side < best.side * (1 - 1e-9)) best = {unit, side}, better = true;
      }
    }
  }
  return best;
}

}  // namespace

double shadow_square(const std::vector<Vec3d>& points, const Vec3d& direction) {
  const Frame frame = across(direction);
  std::vector<Vec3d> shadow;
  shadow.reserve(points.size());
  for (const Vec3d& p : points) shadow.push_back({dot(p, frame.u), dot(p, frame.v), 0});
  constexpr int samples = 36;
  constexpr double spacing = std::numbers::pi / 2 / samples;  // a square repeats after a rotation by 90 degrees
  double best_angle = 0, best = square_side(shadow, 0);
  for (int k = 1; k < samples; ++k) {
    const double side = square_side(shadow, k * spacing);
    if (side < best) best = side, best_angle = k * spacing;
  }
  for (double step = spacing / 2; step > 1e-4; step /= 2) {
    for (const double angle : {best_angle - step, best_angle + step}) {
      const double side = square_side(shadow, angle);
      if (side < best) best = side, best_angle = angle;
    }
  }
  return best;
}

double hull_sieve_size(const std::vector<Vec3d>& all_points) {
  const std::vector<Vec3d> hull = convex_hull(all_points).vertices;  // most vertices of a scan lie inside its hull
  const std::vector<Vec3d> points = outermost(hull);
  std::vector<Passage> passages;
  for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
    passages.push_back({axis, shadow_square(points, axis)});
  }
  constexpr int directions = 150;
  for (int k = 0; k < directions; ++k) {
    const Vec3d d =
        spread_direction((k + 0.5) / directions, k);  // half of the sphere is enough: -d is the same passage
    passages.push_back({d, shadow_square(points, d)});
  }
  std::stable_sort(passages.begin(), passages.end(),
                   [](const Passage& a, const Passage& b) { return a.side < b.side; });
  constexpr int refinements = 4;
  double best = std::numeric_limits<double>::max();
  for (int k = 0; k < refinements; ++k) {
    best = std::min(best, shadow_square(hull, refined(points, passages[k]).direction));
  }
  return best;
}

}  // namespace gyro
