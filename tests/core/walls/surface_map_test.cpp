// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/surface_map.hpp"
#include "core/walls/liners.hpp"
#include "tests/catch.hpp"

#include <numbers>
#include <numeric>

namespace gyro {
namespace {

/// A cylinder of radius 1 m and height 2 m, open, with rock inside.
TriangleMesh cylinder(int sectors) {
  return revolve(ProfileShape{{{1, 0}, {1, 1}, {1, 2}}}, sectors);
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

}  // namespace

TEST_CASE("Cells of an unrolled cylinder have equal areas, also where triangles are larger", "[walls][surface-map]") {
  const int sectors = GENERATE(24, 240);
  const SurfaceMap map(cylinder(sectors), 8, 12);
  const double facet = 2 * std::sin(std::numbers::pi / sectors);  // chord
  const double whole = 2 * sectors * facet;
  CHECK(sum(map.cell_area()) == Approx(whole));
  CHECK(sum(map.triangle_area()) == Approx(whole));
  for (const double area : map.cell_area()) CHECK(area == Approx(whole / 96).epsilon(0.05));
}

TEST_CASE("An impulse is mapped where it acts, with its normal component", "[walls][surface-map]") {
  SurfaceMap map(cylinder(240), 4, 8);
  const double azimuth = GENERATE(0.1, 2.0, -0.5), z = GENERATE(0.3, 1.9);
  const Vec3d outward{std::cos(azimuth), std::sin(azimuth), 0};
  const Vec3d centre = 0.951 * outward + Vec3d{0, 0, z};
  map.add({0, centre, 0.05, 3.0 * outward + Vec3d{0, 0, 1}, 0.25});
  const SurfaceSums cells = map.take_cells();
  const double turn = azimuth < 0 ? azimuth + 2 * std::numbers::pi : azimuth;
  const auto cell = static_cast<std::size_t>(int(z / 0.5) * 8 + int(turn / (std::numbers::pi / 4)));
  CHECK(cells.impulse[cell] == Approx(3).epsilon(1e-3));  // a facet's normal is up to 0.75 degrees off
  CHECK(cells.work[cell] == 0.25);
  CHECK(sum(cells.impulse) == cells.impulse[cell]);
  CHECK(sum(map.take_cells().impulse) == 0);                         // cleared
  CHECK(sum(map.by_triangle().impulse) == Approx(3).epsilon(1e-3));  // kept
  for (std::size_t t = 0; t < map.triangles().size(); ++t) {
    if (map.by_triangle().impulse[t] == 0) continue;
    const WallTriangle& hit = map.triangles()[t];
    CHECK(norm((1.0 / 3) * (hit.a + hit.b + hit.c) - (centre + 0.049 * outward)) < 0.5);
  }
}

TEST_CASE("Archard: depth from the work of sliding", "[walls][surface-map]") {
  // 1000 N pressed on 0.01 m2 slide 50 m at friction 0.5; 1e-12 1/Pa wear 50 nm3 / 0.01 m2.
  CHECK(wear_depth(1e-12, 0.5 * 1000 * 50, 0.5, 0.01) == Approx(1e-12 * 1000 * 50 / 0.01));
  CHECK(wear_depth(1e-12, 1, 0, 0.01) == 0);
}

}  // namespace gyro
