// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapes.hpp"

#include "core/geometry/hull.hpp"
#include "core/geometry/sieve_size.hpp"
#include "core/math/random.hpp"

#include <cmath>
#include <numbers>

namespace gyro {

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
  constexpr std::size_t fine_scan = 2000;  // a scan has a million triangles, and every template keeps a preview
  shape.preview = shape.surface.triangles.size() <= fine_scan ? shape.surface : convex_hull(shape.surface.vertices);
  shape.sieve_size = sieve_size(shape.surface.vertices);
  return shape;
}

RockShape procedural_shape(std::uint64_t seed, std::uint64_t number) {
  std::uint32_t draws = 0;
  const auto draw = [&](double low, double high) {
    return low + (high - low) * uniform(seed, Stream::shape, number, draws++);
  };
  const int count = static_cast<int>(draw(16, 33));
  const double b = draw(0.65, 0.95), c = b * draw(0.65, 0.95);
  std::vector<Vec3d> points;
  for (int k = 0; k < count; ++k) {
    // Fibonacci lattice on the sphere, each point moved by up to half the spacing.
    const double spacing = std::sqrt(4 * std::numbers::pi / count);
    const double z = 1 - (2 * k + 1.0) / count, turn = k * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    Vec3d p{r * std::cos(turn), r * std::sin(turn), z};
    p += (0.5 * spacing) * Vec3d{draw(-1, 1), draw(-1, 1), draw(-1, 1)};
    p = (draw(0.85, 1.0) / norm(p)) * p;
    points.push_back({p.x, b * p.y, c * p.z});
  }
  return make_shape(convex_hull(points));
}

}  // namespace gyro
