// SPDX-License-Identifier: GPL-3.0-or-later
// What the wall list keeps finds every touch that the whole surface has, to the bit.
#include "core/kernels/wall_touch.hpp"
#include "core/kernels/wall_lists.hpp"
#include "core/math/random.hpp"
#include "core/surfaces/mesh_grid.hpp"
#include "core/surfaces/profile_surface.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

using namespace gyro;

namespace {

/// A rough floor of triangles about 0.1 wide, some of them needles, with a step in it.
TriangleMesh rough_floor() {
  TriangleMesh mesh;
  constexpr int n = 11;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto id = static_cast<std::uint64_t>(j * n + i);
      const double step = i > n / 2 ? 0.08 : 0;
      mesh.vertices.push_back({0.1 * i, 0.1 * j * (j == 5 ? 0.801 : 1), step + 0.03 * uniform(1, Stream{}, id, 0)});
    }
  for (Index j = 0; j + 1 < n; ++j)
    for (Index i = 0; i + 1 < n; ++i) {
      const Index a = j * n + i;
      mesh.triangles.push_back({a, a + 1, a + n});
      mesh.triangles.push_back({a + 1, a + n + 1, a + n});
    }
  return mesh;
}

/// Spheres near one wall, listed, and then moved within the skin.
struct Listed {
  static constexpr double skin = 0.05;
  WallSurface surface;
  WallPose pose{{0.1, -0.2, 0.3}, rotation_about({0, 0.6, 0.8}, 0.7), {0, 0, 0}, {0, 0, 0}};
  std::vector<Sphere> spheres{}, bounds{};
  std::vector<WallEntry> entries{};
  std::vector<WallClearance> clearance{};
  std::vector<Index> begin{}, triangles{};
  std::vector<double> gaps{};

  void list(int count) {
    std::vector<Index> rows(static_cast<std::size_t>(count) + 1, 0);
    for (int k = 0; k < count; ++k) {
      const auto draw = [k](std::uint32_t d) { return uniform(2, Stream{}, static_cast<std::uint64_t>(k), d); };
      spheres.push_back({to_world(pose, {draw(0), draw(1), 0.5 * draw(2) - 0.1}), 0.02 + 0.15 * draw(3)});
      bounds.push_back({spheres.back().x, spheres.back().radius + skin});
    }
    ConstParticleView p{};
    p.position = spheres.data();
    const WallsNow walls{&surface, &pose, 1};
    const double way = 0;
    FindWalls find{bounds.data(), walls, &way, {rows.data(), nullptr}};
    for (Index n = 0; n < count; ++n) find(n);
    std::exclusive_scan(rows.begin(), rows.end(), rows.begin(), 0);
    entries.resize(static_cast<std::size_t>(rows.back()));
    find.rows.entries = entries.data();
    for (Index n = 0; n < count; ++n) find(n);
    clearance.resize(entries.size());
    begin.assign(entries.size() + 1, 0);
    MeasureWalls measure{p, walls, bounds.data(), &way, entries.data(), clearance.data(), begin.data()};
    for (Index n = 0; n < size(); ++n) measure(n);
    std::exclusive_scan(begin.begin(), begin.end(), begin.begin(), 0);
    triangles.resize(static_cast<std::size_t>(begin.back()) + 1);
    gaps.resize(triangles.size());
    measure.triangle = triangles.data();
    measure.triangle_gap = gaps.data();
    for (Index n = 0; n < size(); ++n) measure(n);
  }
  Index size() const { return static_cast<Index>(entries.size()); }
};

bool same(const WallTouches& a, const WallTouches& b) {
  const auto equal = [](const WallTouch& s, const WallTouch& t) {
    return s.normal.x == t.normal.x && s.normal.y == t.normal.y && s.normal.z == t.normal.z && s.gap == t.gap &&
           s.weight == t.weight;
  };
  return a.count == b.count && std::equal(a.touch, a.touch + a.count, b.touch, equal);
}

/// A sphere's way since the list was built: as long as the skin, somewhat shorter, or straight to the wall and a hair
/// beyond the first touch.
Vec3d way_of(const Listed& listed, const WallEntry& entry, const Sphere& sphere, Index n, std::uint32_t k) {
  const auto draw = [n, k](std::uint32_t d) {
    return 2 * uniform(3 + k, Stream{}, static_cast<std::uint64_t>(n), d) - 1;
  };
  if (k % 4 == 0) {
    const WallTouches reached =
        touch_wall(listed.surface, entry.range, to_body(listed.pose, sphere.x), sphere.radius + Listed::skin);
    const double free = reached.touch[0].gap + Listed::skin;
    if (free > 0) return -free * (1 + 1e-5 * (1 + draw(0))) * rotate(listed.pose.orientation, reached.touch[0].normal);
  }
  const Vec3d way{draw(0), draw(1), draw(2)};
  return Listed::skin / norm(way) * (k % 4 == 1 ? 1 - 1e-12 : 0.5 + 0.5 * draw(3)) * way;
}

/// Touches of spheres that have moved by up to the skin.
struct Compared {
  int touching = 0, several = 0;
  int different = 0;  ///< from those of the whole surface
};
Compared compared(Listed& listed) {
  listed.list(400);
  const ListedTouches touches{listed.clearance.data(), listed.triangles.data(), listed.gaps.data()};
  REQUIRE(listed.size() > 100);
  Compared c;
  for (Index n = 0; n < listed.size(); ++n)
    for (std::uint32_t k = 0; k < 40; ++k) {
      const WallEntry& entry = listed.entries[static_cast<std::size_t>(n)];
      const Sphere& sphere = listed.spheres[static_cast<std::size_t>(entry.particle)];
      const Vec3d centre = to_body(listed.pose, sphere.x + way_of(listed, entry, sphere, n, k));
      const WallTouches all = touch_wall(listed.surface, entry.range, centre, sphere.radius);
      c.touching += all.count > 0;
      c.several += all.count > 1;
      c.different += !same(all, touches(n, entry, listed.surface, centre, sphere.radius));
    }
  return c;
}

}  // namespace

TEST_CASE("Triangles of the wall list are all that a mesh touches", "[kernels][walls]") {
  const MeshGrid grid(rough_floor());
  Listed listed{.surface = {WallKind::mesh, {}, {}, grid.view(), 1.5}};
  const Compared c = compared(listed);
  CHECK(c.different == 0);
  CHECK(c.touching > 1000);
  CHECK(c.several > 100);
}

TEST_CASE("What was free between a sphere and a profile or a plane hides no touch", "[kernels][walls]") {
  const ProfileSurface profile(ProfileShape{{{0.1, 0}, {0.5, 0.1}, {0.6, 0}, {1.1, 0.05}, {1.2, 0.4}}});
  Listed round{.surface = {WallKind::profile, {}, profile.view(), {}, 1.3}};
  const Compared c = compared(round);
  CHECK(c.different == 0);
  CHECK(c.touching > 1000);
  CHECK(c.several > 100);
  Listed flat{.surface = {WallKind::plane, {{0, 0, 0.1}, {0, 0, 1}}, {}, {}, 1e12}};
  const Compared plane = compared(flat);
  CHECK(plane.different == 0);
  CHECK(plane.touching > 1000);
}
