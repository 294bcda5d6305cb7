// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/sieve_size.hpp"

#include "core/math/quat.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

constexpr double coarse = std::numbers::pi / 12;    ///< between starts of the search [rad]
constexpr double finest = std::numbers::pi / 3600;  ///< where it ends [rad]

/// Three perpendicular unit vectors; the fragment passes the hole along z.
struct Frame {
  Vec3d x, y, z;
};

Frame turned_about(const Frame& f, const Vec3d& axis, double angle) {
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

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Second moments of the spheres' volumes about their common centre. The spheres' own moments
/// are isotropic and turn no axis.
Matrix3 second_moments(std::span<const Vec3d> centres, std::span<const double> radii) {
  double volume = 0;
  Vec3d mean{0, 0, 0};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const double v = radii[i] * radii[i] * radii[i];
    volume += v;
    mean += v * centres[i];
  }
  mean = (1 / volume) * mean;
  Matrix3 m{};
  for (std::size_t i = 0; i < centres.size(); ++i) {
    const Vec3d d = centres[i] - mean;
    const double v = radii[i] * radii[i] * radii[i] / volume;
    const std::array<double, 3> c{d.x, d.y, d.z};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t s = 0; s < 3; ++s) m[r][s] += v * c[r] * c[s];
    }
  }
  return m;
}

/// Turns columns p and q of a matrix by the angle with this cosine and sine.
void orientation_columns(Matrix3& m, std::size_t p, std::size_t q, double c, double s) {
  for (auto& row : m) {
    const double rp = row[p], rq = row[q];
    row[p] = c * rp - s * rq;
    row[q] = s * rp + c * rq;
  }
}

Matrix3 transposed(const Matrix3& m) {
  Matrix3 t{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t s = 0; s < 3; ++s) t[r][s] = m[s][r];
  }
  return t;
}

/// Eigenvectors of a symmetric matrix as columns, by cyclic Jacobi rotations
/// (Golub & Van Loan, Matrix Computations, section 8.5). Core links no linear algebra library.
Matrix3 eigenvectors(Matrix3 m) {
  Matrix3 v{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
  for (int sweep = 0; sweep < 12; ++sweep) {
    for (const auto& [p, q] : pairs) {
      if (m[p][q] == 0) continue;
      const double theta = (m[q][q] - m[p][p]) / (2 * m[p][q]);
      const double t = (theta < 0 ? -1 : 1) / (std::abs(theta) + std::sqrt(theta * theta + 1));
      const double c = 1 / std::sqrt(t * t + 1), s = t * c;
      orientation_columns(m, p, q, c, s);
      m = transposed(m);
      orientation_columns(m, p, q, c, s);
      orientation_columns(v, p, q, c, s);
    }
  }
  return v;
}

Frame principal_frame(std::span<const Vec3d> centres, std::span<const double> radii) {
  const Matrix3 v = eigenvectors(second_moments(centres, radii));
  const Vec3d x{v[0][0], v[1][0], v[2][0]}, y{v[0][1], v[1][1], v[2][1]};
  return {x, y, cross(x, y)};
}

/// The group of spheres, and the square hole that it needs in a frame.
struct Passage {
  std::span<const Vec3d> centres;
  std::span<const double> radii;
  double hole(const Frame& f) const { return std::max(width(centres, radii, f.x), width(centres, radii, f.y)); }
};

/// Turns about any axis of the frame as long as that makes the hole smaller, then in finer steps.
double descended(const Passage& passage, Frame best, double smallest) {
  for (double angle = coarse / 2; angle > finest; angle /= 2) {
    for (bool better = true; better;) {
      better = false;
      // The diagonals are needed where both widths count and one turn must keep both.
      const Vec3d sum = std::numbers::sqrt2 / 2 * (best.x + best.y),
                  difference = std::numbers::sqrt2 / 2 * (best.x - best.y);
      for (const Vec3d& axis :
           {best.x, best.y, best.z, sum, difference, -best.x, -best.y, -best.z, -sum, -difference}) {
        const Frame f = turned_about(best, axis, angle);
        if (const double h = passage.hole(f); h < smallest * (1 - 1e-9)) smallest = h, best = f, better = true;
      }
    }
  }
  return smallest;
}

}  // namespace

double equal_mass_diameter(double mass, double rock_density) {
  return std::cbrt(6 * mass / (std::numbers::pi * rock_density));
}

double square_mesh_size(std::span<const Vec3d> centres, std::span<const double> radii) {
  if (centres.size() == 1) return 2 * radii[0];
  const Passage passage{centres, radii};
  const Frame axes = principal_frame(centres, radii);
  double smallest = passage.hole(axes);
  // Plates and cubes have no unique principal axes, hence starts all around: the axes turned
  // about each of them, each passing in turn, the square turned about the passage.
  for (const Vec3d& about : {axes.x, axes.y, axes.z}) {
    Frame start = axes;
    double hole = passage.hole(start);
    for (int i = 0; i < 6; ++i) {
      const Frame t = turned_about(axes, about, i * coarse);
      for (const Frame& f : {t, Frame{t.y, t.z, t.x}, Frame{t.z, t.x, t.y}}) {
        for (int k = 0; k < 6; ++k) {
          const Frame g = turned_about(f, f.z, k * coarse);
          if (const double h = passage.hole(g); h < hole) hole = h, start = g;
        }
      }
    }
    smallest = std::min(smallest, descended(passage, start, hole));
  }
  return smallest;
}

}  // namespace gyro
