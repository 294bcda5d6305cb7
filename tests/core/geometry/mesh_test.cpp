// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mesh.hpp"
#include "core/geometry/edges.hpp"
#include "core/geometry/inside.hpp"
#include "core/geometry/mesh_repair.hpp"
#include "core/geometry/principal_axes.hpp"
#include "core/math/quat.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"
#include "tests/core/geometry/meshes.hpp"

#include <numbers>

using namespace gyro;

TEST_CASE("A block far from the origin has the textbook integrals") {
  const Vec3d low{1000, -2000, 3000};
  const MassProperties p = mass_properties(block({2, 3, 5}, low));
  CHECK(p.volume == Approx(30).epsilon(1e-12));
  CHECK(norm(p.centroid - (low + Vec3d{1, 1.5, 2.5})) < 1e-9);
  CHECK(p.inertia[0] == Approx(30.0 / 12 * (9 + 25)).epsilon(1e-12));
  CHECK(p.inertia[1] == Approx(30.0 / 12 * (4 + 25)).epsilon(1e-12));
  CHECK(p.inertia[2] == Approx(30.0 / 12 * (4 + 9)).epsilon(1e-12));
  for (int k = 3; k < 6; ++k) CHECK(std::abs(p.inertia[k]) < 1e-9);
}

TEST_CASE("A tetrahedron has the textbook products of inertia") {
  // Corner at 0, legs 1: V = 1/6, int xy = 1/120, centroid 1/4.
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const MassProperties p = mass_properties(mesh);
  CHECK(p.volume == Approx(1.0 / 6).epsilon(1e-14));
  CHECK(p.inertia[3] == Approx(-(1.0 / 120 - 1.0 / 6 / 16)).epsilon(1e-12));
  CHECK(p.inertia[0] == Approx(2 * (1.0 / 60 - 1.0 / 6 / 16)).epsilon(1e-12));
}

TEST_CASE("Principal axes undo a rotation") {
  TriangleMesh mesh = block({5, 3, 2});
  const Quatd orientation = rotation_about({0.6, 0, 0.8}, 1.1);
  for (Vec3d& v : mesh.vertices) v = rotate(orientation, v);
  const PrincipalAxes axes = principal_axes(mass_properties(mesh).inertia);
  CHECK(axes.moments.x == Approx(30.0 / 12 * (9 + 4)));
  CHECK(axes.moments.z == Approx(30.0 / 12 * (25 + 9)));
  CHECK(std::abs(dot(axes.axes[0], rotate(orientation, Vec3d{1, 0, 0}))) == Approx(1));
  CHECK(dot(cross(axes.axes[0], axes.axes[1]), axes.axes[2]) == Approx(1));
}

TEST_CASE("The edge check distinguishes a solid from a surface with faults") {
  TriangleMesh mesh = block({1, 1, 1});
  CHECK(check_edges(mesh).is_solid());
  SECTION("a hole of one triangle has three open edges") {
    mesh.triangles.pop_back();
    CHECK(check_edges(mesh).open == 3);
  }
  SECTION("a flipped triangle contradicts its three neighbours") {
    std::swap(mesh.triangles[4].x, mesh.triangles[4].y);
    CHECK(check_edges(mesh).contradictory == 3);
    CHECK(orient_outwards(mesh) == 1);
    CHECK(check_edges(mesh).is_solid());
    CHECK(mass_properties(mesh).volume == Approx(1));
  }
  SECTION("a fin makes a crowded edge") {
    mesh.vertices.push_back({2, 2, 2});
    mesh.triangles.push_back({0, 1, 8});
    CHECK(check_edges(mesh).crowded == 1);
    CHECK(check_edges(mesh).open == 2);
  }
  SECTION("inside out: all triangles are flipped") {
    for (auto& t : mesh.triangles) std::swap(t.x, t.y);
    CHECK(orient_outwards(mesh) == 12);
    CHECK(mass_properties(mesh).volume == Approx(1));
  }
  SECTION("two blocks are two bodies") {
    const TriangleMesh other = block({1, 1, 1}, {5, 5, 5});
    for (const auto& t : other.triangles) mesh.triangles.push_back({t.x + 8, t.y + 8, t.z + 8});
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    CHECK(check_edges(mesh).bodies == 2);
  }
}

TEST_CASE("Welding joins separate triangles, also across cells of its grid") {
  const TriangleMesh mesh = block({1, 1, 1}, {-0.5, -0.5, -0.5});
  TriangleMesh soup;
  for (const auto& t : mesh.triangles) {
    for (const Index v : {t.x, t.y, t.z}) {
      const double jitter = 1e-7 * (static_cast<double>(soup.vertices.size() % 5) - 2);
      soup.vertices.push_back(mesh.vertices[v] + Vec3d{jitter, -jitter, jitter});
    }
    const Index n = static_cast<Index>(soup.vertices.size());
    soup.triangles.push_back({n - 3, n - 2, n - 1});
  }
  const TriangleMesh welded = weld(soup, 1e-6);
  CHECK(welded.vertices.size() == 8);
  CHECK(check_edges(welded).is_solid());
}

TEST_CASE("Inside and outside, convex and not, agree with volumes") {
  const auto share_inside = [](const TriangleMesh& mesh) {
    const InsideTest inside(mesh);
    const Box box = bounding_box(mesh);
    int hits = 0;
    constexpr int points = 20000;
    for (int k = 0; k < points; ++k) {
      const auto draw = [&](std::uint32_t d) { return uniform(3, Stream::place, k, d); };
      const Vec3d size = box.high - box.low;
      hits += inside.contains(box.low + Vec3d{size.x * draw(0), size.y * draw(1), size.z * draw(2)});
    }
    return static_cast<double>(hits) / points;
  };
  CHECK(InsideTest(block({1, 2, 3})).convex());
  CHECK_FALSE(InsideTest(corner_piece()).convex());
  CHECK_FALSE(InsideTest(corner_piece()).contains({1.5, 1.5, 0.5}));
  CHECK(InsideTest(corner_piece()).contains({0.5, 1.5, 0.5}));
  // Four standard deviations of the count.
  CHECK(std::abs(share_inside(corner_piece()) - 0.75) < 4 * std::sqrt(0.75 * 0.25 / 20000));
  const TriangleMesh ball = ellipsoid(1, 1, 1, 400);
  CHECK_FALSE(InsideTest(ball).convex());  // too many faces for planes: by the tree
  const Box box = bounding_box(ball);
  const Vec3d size = box.high - box.low;
  const double share = mass_properties(ball).volume / (size.x * size.y * size.z);
  CHECK(std::abs(share_inside(ball) - share) < 4 * std::sqrt(share * (1 - share) / 20000));
}
