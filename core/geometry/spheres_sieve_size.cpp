// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/principal_axes.hpp"
#include "core/geometry/sieve_size.hpp"
#include "core/math/quat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

constexpr double coarse = std::numbers::pi / 12;    ///< spacing of the starts of the search [rad]
constexpr double finest = std::numbers::pi / 3600;  ///< step at which the search ends [rad]

/// Three perpendicular unit vectors; the group passes the opening along z.
struct Frame {
  Vec3d x, y, z;
};

Frame rotated_about(const Frame& f, const Vec3d& axis, double angle) {
  const Quatd q = rotation_about(axis, angle);
  return {rotate(q, f.x), rotate(q, f.y), rotate(q, f.z)};
}

/// Extent of the spheres along a unit vector [m].
double width(std::span<const Vec3d> centres, std::span<const double> radii, const Vec3d& along) {
  double low = dot(centres[0], along) - radii[0], high = dot(centres[0], along) + radii[0];
  for (std::size_t i = 1; i < centres.size(); ++i) {
    const double s = dot(centres[i], along);
    low = std::min(low, s - radii[i]);
    high = std::max(high, s + radii[i]);
  }
  return high - low;
}

/// The principal axes of the spheres' volumes about their common centre, from the shortest to the longest extent. Each
/// sphere is treated as a point mass, because its own second moments are the same in all directions.
Frame principal_frame(std::span<const Vec3d> centres, std::span<const double> radii) {
  double volume = 0;
  Vec3d mean{0, 0, 0};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double v = radii[i] * radii[i] * radii[i];
    volume += v;
    mean += v * centres[i];
  }
  mean = (1 / volume) * mean;
  std::array<double, 6> tensor{};  // xx, yy, zz, xy, yz, zx
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Vec3d d = centres[i] - mean;
    const double v = radii[i] * radii[i] * radii[i] / volume;
    tensor[0] += v * d.x * d.x;
    tensor[1] += v * d.y * d.y;
    tensor[2] += v * d.z * d.z;
    tensor[3] += v * d.x * d.y;
    tensor[4] += v * d.y * d.z;
    tensor[5] += v * d.z * d.x;
  }
  const PrincipalAxes principal = principal_axes(tensor);
  return {principal.axes[0], principal.axes[1], principal.axes[2]};
}

/// A group of spheres and the square opening through which it passes in a frame.
struct Passage {
  std::span<const Vec3d> centres;
  std::span<const double> radii;
  double opening(const Frame& f) const { return std::max(width(centres, radii, f.x), width(centres, radii, f.y)); }
};

/// Rotates about the axes of the frame while that makes the opening smaller, in successively finer steps.
double descended(const Passage& passage, Frame best, double smallest) {
  for (double angle = coarse / 2; angle > finest; angle /= 2) {
    for (bool better = true; better;) {
      better = false;
      // The diagonals are needed where both widths are equal and a rotation must reduce both.
      const Vec3d sum = std::numbers::sqrt2 / 2 * (best.x + best.y),
                  difference = std::numbers::sqrt2 / 2 * (best.x - best.y);
      for (const Vec3d& axis :
           {best.x, best.y, best.z, sum, difference, -best.x, -best.y, -best.z, -sum, -difference}) {
        const Frame f = rotated_about(best, axis, angle);
        if (const double w = passage.opening(f); w < smallest * (1 - 1e-9)) smallest = w, best = f, better = true;
      }
    }
  }
  return smallest;
}

}  // namespace

double spheres_sieve_size(std::span<const Vec3d> centres, std::span<const double> radii) {
  if (centres.size() == 1) return 2 * radii[0];
  const Passage passage{centres, radii};
  const Frame axes = principal_frame(centres, radii);
  double smallest = passage.opening(axes);
  // Plates and cubes have no unique principal axes, so the search starts from many frames: rotated about each of the
  // principal axes, with each axis as the passage, and with the square rotated about the passage.
  for (const Vec3d& about : {axes.x, axes.y, axes.z}) {
    Frame start = axes;
    double opening = passage.opening(start);
    for (int i = 0; i < 6; ++i) {
      const Frame t = rotated_about(axes, about, i * coarse);
      for (const Frame& f : {t, Frame{t.y, t.z, t.x}, Frame{t.z, t.x, t.y}}) {
        for (int k = 0; k < 6; ++k) {
          const Frame g = rotated_about(f, f.z, k * coarse);
          if (const double w = passage.opening(g); w < opening) opening = w, start = g;
        }
      }
    }
    smallest = std::min(smallest, descended(passage, start, opening));
  }
  return smallest;
}

}  // namespace gyro
