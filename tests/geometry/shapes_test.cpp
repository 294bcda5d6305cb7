// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/shapes.hpp"
#include "core/geometry/sieve_size.hpp"
#include "core/math/quat.hpp"
#include "tests/catch.hpp"
#include "tests/geometry/meshes.hpp"

#include <set>

using namespace gyro;

TEST_CASE("A hull is a solid around its points") {
  const TriangleMesh hull = convex_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}});
  CHECK(hull.vertices.size() == 4);
  CHECK(check_edges(hull).is_solid());
  CHECK(mass_properties(hull).volume == Approx(1.0 / 6));
}

TEST_CASE("The sieve size of a block is its middle edge, however it lies") {
  std::vector<Vec3d> corners = block({2, 3, 5}).vertices;
  CHECK(sieve_size(corners) == Approx(3).epsilon(1e-9));
  const Quatd turn = rotation_about({0.36, 0.48, 0.8}, 0.7);
  for (Vec3d& v : corners) v = rotate(turn, v);
  CHECK(sieve_size(corners) == Approx(3).epsilon(2e-3));
  CHECK(sieve_size(corners) > 3 * (1 - 1e-9));  // a search from above
}

TEST_CASE("A flat block goes through the diagonal of the mesh") {
  // A 0.5 x 3 section turned by 45 degrees fits a square of (0.5 + 3)/sqrt 2.
  CHECK(sieve_size(block({0.5, 3, 5}).vertices) == Approx(3.5 / std::sqrt(2.0)).epsilon(2e-3));
}

TEST_CASE("The sieve size of an ellipsoid is the bounding square of its turned section") {
  const double b = 0.8, c = 0.5;
  const TriangleMesh mesh = ellipsoid(1.3, b, c, 4000);
  CHECK(sieve_size(mesh.vertices) == Approx(2 * std::sqrt((b * b + c * c) / 2)).epsilon(3e-3));
}

TEST_CASE("Procedural rocks are normalised solids of the stated proportions") {
  std::set<std::size_t> faces;
  for (int k = 0; k < 40; ++k) {
    const RockShape rock = procedural_shape(7, k);
    CAPTURE(k);
    CHECK(check_edges(rock.surface).is_solid());
    const MassProperties p = mass_properties(rock.surface);
    CHECK(p.volume == Approx(1).epsilon(1e-12));
    CHECK(norm(p.centroid) < 1e-12);
    CHECK(p.inertia[0] == Approx(rock.inertia.x).epsilon(1e-10));
    CHECK(p.inertia[2] == Approx(rock.inertia.z).epsilon(1e-10));
    for (int d = 3; d < 6; ++d) CHECK(std::abs(p.inertia[d]) < 1e-10);
    CHECK(rock.inertia.x <= rock.inertia.y);
    CHECK(rock.inertia.y <= rock.inertia.z);
    // Axes of the ellipsoid of the same moments: c/a from 0.42 to 0.9 as drawn, and some jitter.
    const Vec3d i = rock.inertia;
    const double flatness = std::sqrt((i.x + i.y - i.z) / (i.y + i.z - i.x));
    CHECK(flatness > 0.35);
    CHECK(flatness < 1);
    const double diameter = std::cbrt(6 / 3.14159265358979);
    CHECK(rock.sieve_size > 0.7 * diameter);
    CHECK(rock.sieve_size < 1.1 * diameter);
    faces.insert(rock.surface.triangles.size());
  }
  CHECK(faces.size() > 5);
}

TEST_CASE("A shape depends on seed and number only") {
  const RockShape a = procedural_shape(7, 3), b = procedural_shape(7, 3), c = procedural_shape(8, 3);
  REQUIRE(a.surface.vertices.size() == b.surface.vertices.size());
  CHECK(a.surface.vertices[5].x == b.surface.vertices[5].x);
  CHECK(a.inertia.x == b.inertia.x);
  CHECK(a.inertia.x != c.inertia.x);
}

TEST_CASE("A fine scan keeps its surface for filling and its hull for previews") {
  TriangleMesh scan = ellipsoid(1, 0.8, 0.6, 3000);
  for (std::size_t k = 0; k < scan.vertices.size(); k += 2) scan.vertices[k] = 0.98 * scan.vertices[k];
  const RockShape rock = make_shape(scan);
  CHECK(rock.surface.triangles.size() == scan.triangles.size());
  CHECK(rock.preview.triangles.size() < 0.7 * static_cast<double>(scan.triangles.size()));
  CHECK(mass_properties(rock.preview).volume > 1);
  CHECK(procedural_shape(1, 1).preview.triangles.size() == procedural_shape(1, 1).surface.triangles.size());
}
