// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/sieve_size.hpp"
#include "core/geometry/shapes.hpp"
#include "core/math/quat.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"

#include <algorithm>
#include <cmath>

using namespace gyro;

namespace {

const double d = 0.02, R = d / 2;

Quatd random_orientation(std::uint64_t k) {
  const auto u = [k](std::uint32_t draw) { return 2 * uniform(1, Stream::turn, k, draw) - 1; };
  return normalised(Quatd{u(0), u(1), u(2), u(3)});
}

std::vector<Vec3d> rotated(std::vector<Vec3d> centres, const Quatd& q) {
  for (Vec3d& c : centres) c = rotate(q, c);
  return centres;
}

/// Centres of spheres of the diameter d on a cubic lattice.
std::vector<Vec3d> lattice(int nx, int ny, int nz) {
  std::vector<Vec3d> centres;
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) centres.push_back({x * d, y * d, z * d});
  return centres;
}

double size_of(const std::vector<Vec3d>& centres) {
  return spheres_sieve_size(centres, std::vector<double>(centres.size(), R));
}

}  // namespace

TEST_CASE("The sieve size of a block is its middle edge in any orientation") {
  std::vector<Vec3d> corners = block({2, 3, 5}).vertices;
  CHECK(hull_sieve_size(corners) == Approx(3).epsilon(1e-9));
  corners = rotated(corners, rotation_about({0.36, 0.48, 0.8}, 0.7));
  CHECK(hull_sieve_size(corners) == Approx(3).epsilon(2e-3));
  CHECK(hull_sieve_size(corners) > 3 * (1 - 1e-9));  // the search approaches from above
}

TEST_CASE("A flat block passes along the diagonal of the opening") {
  // A 0.5 x 3 section rotated by 45 degrees fits a square of (0.5 + 3)/sqrt 2.
  CHECK(hull_sieve_size(block({0.5, 3, 5}).vertices) == Approx(3.5 / std::sqrt(2.0)).epsilon(2e-3));
}

TEST_CASE("The sieve size of an ellipsoid is the bounding square of its rotated section") {
  const double b = 0.8, c = 0.5;
  const TriangleMesh mesh = ellipsoid(1.3, b, c, 4000);
  CHECK(hull_sieve_size(mesh.vertices) == Approx(2 * std::sqrt((b * b + c * c) / 2)).epsilon(3e-3));
}

TEST_CASE("A 2 x 3 x 5 block passes a square opening of 3 in any orientation", "[fragments]") {
  for (std::uint64_t k = 0; k < 20; ++k) {
    CHECK(size_of(rotated(lattice(2, 3, 5), random_orientation(k))) == Approx(3 * d).epsilon(2e-3));
  }
}

TEST_CASE("A rod passes an opening of its thickness, and a plate passes along the diagonal", "[fragments]") {
  for (std::uint64_t k = 0; k < 20; ++k) {
    CHECK(size_of(rotated(lattice(12, 1, 1), random_orientation(k))) == Approx(d).epsilon(2e-3));
    // n x n x 1 spheres stood on edge: centres span (n-1) d at angle t to the mesh, so that both
    // widths are least at 45 degrees: (n-1) d / sqrt(2) + d.
    CHECK(size_of(rotated(lattice(8, 8, 1), random_orientation(k))) ==
          Approx((7 / std::sqrt(2.0) + 1) * d).epsilon(2e-3));
  }
}

TEST_CASE("A cube has no unique principal axes and still passes an opening of its edge", "[fragments]") {
  for (std::uint64_t k = 0; k < 20; ++k) {
    CHECK(size_of(rotated(lattice(4, 4, 4), random_orientation(k))) == Approx(4 * d).epsilon(2e-3));
  }
}

TEST_CASE("An ellipsoid of many small spheres passes sqrt((b^2 + c^2)/2)", "[fragments]") {
  const double b = 0.3, c = 0.2;  // semi-axes
  const std::vector<Vec3d> centres = ellipsoid(0.5, b, c, 4000).vertices;
  const std::vector<double> radii(centres.size(), 1e-9);
  const double exact = 2 * std::sqrt((b * b + c * c) / 2);
  CHECK(spheres_sieve_size(rotated(centres, random_orientation(7)), radii) == Approx(exact).epsilon(3e-3));
}

TEST_CASE("The quick search is close to the thorough one", "[fragments]") {
  double sum = 0, largest = 0;
  constexpr int rocks = 40;
  for (int k = 0; k < rocks; ++k) {
    const std::vector<Vec3d> corners = procedural_shape(3, k).surface.vertices;
    const double excess = spheres_sieve_size(corners, std::vector(corners.size(), 1e-9)) / hull_sieve_size(corners) - 1;
    CHECK(excess > -0.015);  // the thorough search is not exact either
    sum += excess;
    largest = std::max(largest, excess);
  }
  CHECK(sum / rocks < 5e-3);
  CHECK(largest < 0.06);
}
