// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surfaces/mesh_grid.hpp"
#include "app/verify/fixtures/meshes.hpp"
#include "app/verify/fixtures/random.hpp"
#include "core/base/errors.hpp"
#include "core/math/random.hpp"
#include "core/surfaces/touch_wall.hpp"
#include "tests/catch.hpp"

#include <algorithm>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

TriangleMesh moved(TriangleMesh mesh, const Quatd& q, const Vec3d& shift) {
  for (Vec3d& v : mesh.vertices) v = shift + rotate(q, v);
  return mesh;
}

void check_plane(const MeshGrid& mesh, const Vec3d& centre, double radius, const Vec3d& normal, double gap) {
  const WallTouches t = touch_mesh(mesh.view(), centre, radius);
  REQUIRE(t.count == 1);
  CHECK(t.touch[0].weight == 1);
  CHECK(std::abs(t.touch[0].gap - gap) < 1e-12 * radius);
  CHECK(norm(t.touch[0].normal - normal) < 1e-12);
}

}  // namespace

TEST_CASE("M1: a flat mesh gives the same contact on vertices and edges, in any orientation") {
  const TriangleMesh flat = split_square(1, 120);
  // Rounding of the rotated corners tilts a triangle by about 2^-52 / height.
  double height = 1;
  for (const Vec3<Index>& t : flat.triangles) {
    const auto at = [&](Index k) { return flat.vertices[static_cast<std::size_t>(k)]; };
    const double longest = std::max({norm(at(t.x) - at(t.y)), norm(at(t.y) - at(t.z)), norm(at(t.z) - at(t.x))});
    height = std::min(height, slimness(flat, t) * longest);
  }
  const double tolerance = std::max(1e-9, 4 * 2.2e-16 / height);
  INFO("smallest height " << height);
  const Quatd q = rotation_about(1 / std::sqrt(3.0) * Vec3d{1, 1, 1}, 0.8);
  const MeshGrid mesh(moved(flat, q, {0.3, -0.2, 0.5}));
  const double radius = 0.02;
  for (const Vec3<Index>& t : flat.triangles)
    for (const double part : {0.0, 0.5}) {
      const Vec3d &a = flat.vertices[static_cast<std::size_t>(t.x)], &b = flat.vertices[static_cast<std::size_t>(t.y)];
      const Vec3d foot = (1 - part) * a + part * b;
      if (std::max(std::abs(foot.x), std::abs(foot.y)) > 0.99) continue;
      const Vec3d centre = Vec3d{0.3, -0.2, 0.5} + rotate(q, foot + Vec3d{0, 0, -0.95 * radius});
      const WallTouches w = touch_mesh(mesh.view(), centre, radius);
      double weight = 0, gap = 0;
      Vec3d normal{0, 0, 0};
      for (int k = 0; k < w.count; ++k) {
        weight += w.touch[k].weight;
        gap += w.touch[k].weight * w.touch[k].gap;
        normal += w.touch[k].weight * w.touch[k].normal;
      }
      CHECK(w.count == 1);
      CHECK(std::abs(weight - 1) < 1e-9);
      CHECK(std::abs(gap + 0.05 * radius) < 1e-9 * radius);
      CHECK(norm(normal + rotate(q, Vec3d{0, 0, 1})) < tolerance);
    }
}

TEST_CASE("H7: each side of a plate of two faces touches its own face only") {
  const double thick = 0.004;
  const TriangleMesh below = moved(split_square(1, 30), {1, 0, 0, 0}, {0, 0, -thick});
  const MeshGrid mesh(joined(split_square(1, 50), below));
  check_plane(mesh, {0.1, 0.2, 0.009}, 0.01, {0, 0, 1}, -0.001);
  check_plane(mesh, {0.1, 0.2, -thick - 0.009}, 0.01, {0, 0, -1}, -0.001);
}

TEST_CASE("H21: degenerate and repeated triangles are dropped, NaN is refused") {
  TriangleMesh mesh = split_square(1, 40);
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({mesh.triangles[3].y, mesh.triangles[3].x, mesh.triangles[3].z});
  mesh.vertices.push_back({0, -1, 0});  // on the edge from vertex 0 to 1
  mesh.triangles.push_back({0, 1, static_cast<Index>(mesh.vertices.size()) - 1});
  const MeshGrid grid(mesh);
  CHECK(grid.degenerate() == 2);
  CHECK(grid.duplicates() == 1);
  CHECK(grid.triangles().size() == mesh.triangles.size() - 3);
  check_plane(grid, {0.2, 0.1, 0.009}, 0.01, {0, 0, 1}, -0.001);
  mesh.vertices[2].y = NAN;
  CHECK_THROWS_AS(MeshGrid(mesh), BadInput);
  CHECK_THROWS_AS(MeshGrid({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 3}}}), BadInput);
  CHECK_THROWS_AS(MeshGrid({}), BadInput);
}

TEST_CASE("H22: with needles, huge triangles and outliers the lists stay short and contacts right") {
  TriangleMesh mesh = split_square(1, 2000);
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const auto n = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), {a, b, c});
    mesh.triangles.push_back({n, n + 1, n + 2});
  };
  add({-500, -500, -3}, {500, -500, -3}, {0, 800, -3});  // huge
  add({-5, 0, 2}, {5, 0, 2}, {5, 1e-5, 2});              // needle of aspect 1e6
  add({1000, 1000, 1000}, {1000.1, 1000, 1000}, {1000, 1000.1, 1000});
  const MeshGrid grid(mesh);
  CHECK(grid.cell_begin().size() < 20 * mesh.triangles.size() + 200);
  CHECK(grid.items().size() < 64 * mesh.triangles.size());
  check_plane(grid, {0.2, 0.1, 0.009}, 0.01, {0, 0, 1}, -0.001);
  check_plane(grid, {33, -12, -2.91}, 0.1, {0, 0, 1}, -0.01);
  check_plane(grid, {2, 5e-6, 2.009}, 0.01, {0, 0, 1}, -0.001);
  CHECK(touch_mesh(grid.view(), {1e6, 0, 0}, 0.1).count == 0);
}

TEST_CASE("Grid, list and all triangles give the same bits, in any order") {
  TriangleMesh mesh = split_square(1, 300);
  for (Vec3d& v : mesh.vertices) v.z = 0.2 * v.x * v.x - 0.3 * v.y * v.y + 0.05 * std::sin(20 * v.x);
  const MeshGrid grid(mesh);
  std::vector<Index> all(grid.triangles().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<Index>(i);
  int touching = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const Vec3d c{1.8 * random_share(i, 0) - 0.9, 1.8 * random_share(i, 1) - 0.9, 0.3 * random_share(i, 2)};
    const double radius = 0.02 + 0.1 * random_share(i, 3);
    const WallTouches a = touch_mesh(grid.view(), c, radius);
    std::vector<Index> ids = grid.candidates(c, radius + 0.02);
    CHECK(std::is_sorted(ids.begin(), ids.end()));
    const WallTouches b =
        touch_triangles(grid.triangles().data(), ids.data(), static_cast<Index>(ids.size()), c, radius);
    std::vector<Index> reversed(all.rbegin(), all.rend());
    const WallTouches d =
        touch_triangles(grid.triangles().data(), reversed.data(), static_cast<Index>(reversed.size()), c, radius);
    Index near[512];
    const Index count = triangles_near(grid.view(), c, radius, near, 512);
    REQUIRE(count <= 512);
    const WallTouches e = touch_triangles(grid.triangles().data(), near, count, c, radius);
    if (count > 2) CHECK(triangles_near(grid.view(), c, radius, near, count - 1) == count);
    for (const WallTouches& other : {b, d, e}) {
      REQUIRE(other.count == a.count);
      for (int k = 0; k < a.count; ++k) {
        CHECK(other.touch[k].gap == a.touch[k].gap);
        CHECK(other.touch[k].weight == a.touch[k].weight);
        CHECK(norm(other.touch[k].normal - a.touch[k].normal) == 0);
      }
    }
    touching += a.count > 0;
  }
  CHECK(touching > 300);
}
