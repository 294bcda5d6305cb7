// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapes.hpp"

#include "core/base/errors.hpp"
#include "core/geometry/hull.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/geometry/rough_surface.hpp"
#include "core/geometry/sieve_size.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

struct Corner {
  double x, y;
};

/// A polygon of 64 sides with the area of a circle of diameter 1, cut by the two flats, which face y and span the
/// loading angle as seen from the axis.
std::vector<Corner> section_of(double loading_angle) {
  constexpr int steps = 64;
  const double radius = std::sqrt(std::numbers::pi / 2 / (steps * std::sin(2 * std::numbers::pi / steps)));
  const double flat = loading_angle > 0 ? radius * std::cos(loading_angle / 2) : 2 * radius;
  const auto corner = [&](int k) {
    const double azimuth = 2 * std::numbers::pi * k / steps;
    return Corner{radius * std::cos(azimuth), radius * std::sin(azimuth)};
  };
  std::vector<Corner> section;
  for (int k = 0; k < steps; ++k) {
    const Corner here = corner(k), next = corner(k + 1);
    const bool kept = std::abs(here.y) < flat;
    if (kept) section.push_back(here);
    if (kept == (std::abs(next.y) < flat)) continue;
    const double cut = std::copysign(flat, here.y), share = (cut - here.y) / (next.y - here.y);
    section.push_back({here.x + share * (next.x - here.x), cut});
  }
  return section;
}

}  // namespace

RockShape make_shape(const TriangleMesh& solid) {
  const MassProperties raw = mass_properties(solid);
  const PrincipalAxes principal = principal_axes(raw.inertia);
  const double scale = 1 / std::cbrt(raw.volume);
  RockShape shape;
  shape.surface = moved(solid, raw.centroid, scale);
  for (Vec3d& v : shape.surface.vertices) {
    v = {dot(principal.axes[0], v), dot(principal.axes[1], v), dot(principal.axes[2], v)};
  }
  shape.inertia = std::pow(scale, 5) * principal.moments;
  constexpr std::size_t fine_scan = 2000;  // triangles; a scan may have a million, and every template keeps a preview
  shape.preview = shape.surface.triangles.size() <= fine_scan ? shape.surface : convex_hull(shape.surface.vertices);
  shape.sieve_size = hull_sieve_size(shape.surface.vertices);
  return shape;
}

void check_style(const ShapeStyle& style) {
  for (const ShapeStyle::Interval& ratio : {style.elongation, style.flatness}) {
    if (!(ratio.low > 0 && ratio.low <= ratio.high && ratio.high <= 1))
      throw BadInput("rocks.shapes: elongation and flatness must be intervals with 0 < low <= high <= 1");
  }
  if (!(style.angularity >= 0 && style.angularity <= 1))
    throw BadInput("rocks.shapes.angularity must be between 0 and 1");
  if (!(style.roughness >= 0 && style.roughness <= 0.3))
    throw BadInput("rocks.shapes.roughness must be between 0 and 0.3");
}

RockShape procedural_shape(std::uint64_t seed, std::uint64_t number, const ShapeStyle& style) {
  std::uint32_t draws = 0;
  const auto draw = [&](double low, double high) {
    return low + (high - low) * uniform(seed, Stream::shape, number, draws++);
  };
  // At least 16 points in the middle of the scale, 2.5 times as many at 0, 2.5 times fewer at 1.
  const double min_points = std::round(16 * std::pow(2.5, 1 - 2 * style.angularity));
  const int count = static_cast<int>(draw(min_points, 2 * min_points + 1));
  const double b = draw(style.elongation.low, style.elongation.high);
  const double c = b * draw(style.flatness.low, style.flatness.high);
  std::vector<Vec3d> points;
  for (int k = 0; k < count; ++k) {
    // Fibonacci lattice on the sphere, each point moved by up to half the spacing.
    const double spacing = std::sqrt(4 * std::numbers::pi / count);
    const double z = 1 - (2 * k + 1.0) / count, azimuth = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    Vec3d p{r * std::cos(azimuth), r * std::sin(azimuth), z};
    p += (0.5 * spacing) * Vec3d{draw(-1, 1), draw(-1, 1), draw(-1, 1)};
    p = (draw(0.85, 1.0) / norm(p)) * p;
    points.push_back({p.x, b * p.y, c * p.z});
  }
  const TriangleMesh hull = convex_hull(points);
  if (style.roughness == 0) return make_shape(hull);
  const TriangleMesh centred = moved(hull, mass_properties(hull).centroid, 1);
  return make_shape(roughened(centred, style.roughness, seed, number, draws));
}

RockShape cylinder_shape(double slenderness, double loading_angle) {
  const std::vector<Corner> section = section_of(loading_angle);
  const auto sides = static_cast<Index>(section.size());
  TriangleMesh prism{{{0, 0, 0}, {0, 0, slenderness}}, {}};
  for (const Corner& c : section) {
    prism.vertices.push_back({c.x, c.y, 0});
    prism.vertices.push_back({c.x, c.y, slenderness});
  }
  for (Index k = 0; k < sides; ++k) {
    const Index low = 2 + 2 * k, high = low + 1, next_low = 2 + 2 * ((k + 1) % sides), next_high = next_low + 1;
    prism.triangles.push_back({0, next_low, low});
    prism.triangles.push_back({1, high, next_high});
    prism.triangles.push_back({low, next_low, next_high});
    prism.triangles.push_back({low, next_high, high});
  }
  return make_shape(prism);
}

TriangleMesh coarse_polyhedron(const TriangleMesh& scan, int corners) {
  const TriangleMesh hull = convex_hull(scan.vertices);
  if (static_cast<int>(hull.vertices.size()) <= corners) return hull;
  std::vector<bool> kept(hull.vertices.size(), false);
  for (int k = 0; k < corners; ++k) {
    const double z = 1 - (2 * k + 1.0) / corners, azimuth = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    const Vec3d d{r * std::cos(azimuth), r * std::sin(azimuth), z};
    const auto further = [&](const Vec3d& p, const Vec3d& q) { return dot(p, d) < dot(q, d); };
    kept[std::max_element(hull.vertices.begin(), hull.vertices.end(), further) - hull.vertices.begin()] = true;
  }
  std::vector<Vec3d> points;
  for (std::size_t v = 0; v < hull.vertices.size(); ++v) {
    if (kept[v]) points.push_back(hull.vertices[v]);
  }
  return convex_hull(points);
}

}  // namespace gyro
