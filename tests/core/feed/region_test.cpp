// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/feed/region.hpp"

#include "core/base/errors.hpp"
#include "core/feed/wall_distance.hpp"
#include "core/math/random.hpp"
#include "core/walls/liners.hpp"
#include "scenes.hpp"
#include "tests/catch.hpp"

using namespace gyro;

TEST_CASE("The radius of a liner by height is that of its profile", "[feed]") {
  const std::vector<Wall> walls = chamber_walls();
  const RadiusByHeight outer(walls[0], RadiusByHeight::Side::outer), inner(walls[1], RadiusByHeight::Side::inner);
  const double slice = 3.4 / 512;  // the radius is on the safe side by at most the slope times this
  CHECK(outer.low() == 0);
  CHECK(outer.high() == 3.2);
  CHECK(outer.at(1.25) == Approx((1.140 + 1.263) / 2).margin(slice * 0.3));
  CHECK(outer.at(1.25) <= (1.140 + 1.263) / 2);
  CHECK(inner.at(1.25) == Approx((0.630 + 0.512) / 2).margin(slice * 0.3));
  CHECK(inner.at(1.25) >= (0.630 + 0.512) / 2);
  CHECK(inner.at(3.5) == 0);
  CHECK(inner.at(-1) == Approx(0.953));
  CHECK(outer.at(4) == Approx(1.819).margin(slice * 0.4));
}

TEST_CASE("A mesh of a liner has the radius of its profile, except for its facets", "[feed]") {
  const std::vector<Wall> walls = chamber_walls();
  const int sectors = 90;
  const Wall outer_mesh{"concave", revolve(std::get<ProfileShape>(walls[0].shape), sectors), Fixed{}, 0};
  const Wall inner_mesh{"mantle", revolve(std::get<ProfileShape>(walls[1].shape), sectors), Fixed{}, 0};
  const RadiusByHeight outer(walls[0], RadiusByHeight::Side::outer), inner(walls[1], RadiusByHeight::Side::inner);
  const RadiusByHeight outer2(outer_mesh, RadiusByHeight::Side::outer), inner2(inner_mesh, RadiusByHeight::Side::inner);
  for (double z = 0.05; z < 3.1; z += 0.1) {
    const double sagitta = outer.at(z) * (1 - std::cos(std::numbers::pi / sectors));
    CHECK(outer2.at(z) <= outer.at(z) + 1e-12);
    CHECK(outer2.at(z) >= outer.at(z) - 2 * sagitta);
    CHECK(inner2.at(z) <= inner.at(z) + 1e-12);
    CHECK(inner2.at(z) >= inner.at(z) - 2 * sagitta);
  }
}

TEST_CASE("A triangle that the axis pierces leaves no radius free", "[feed]") {
  const TriangleMesh floor{{{-1, -1, 0}, {1, -1, 0}, {0, 2, 0}}, {{0, 1, 2}}};
  CHECK(RadiusByHeight({"floor", floor, Fixed{}, 0}, RadiusByHeight::Side::outer).at(0) == 0);
}

TEST_CASE("The opening stands on the top edge", "[feed]") {
  const CylinderRegion opening = opening_above(chamber_walls()[0], 1.5);
  CHECK(opening.base.z == 3.2);
  CHECK(opening.radius == Approx(1.819).margin(3e-3));
  CHECK(opening.radius <= 1.819);
  CHECK_THROWS_AS(opening_above({"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 0}, 1), BadInput);
}

TEST_CASE("Distances to a profile are exact and signed", "[feed]") {
  const std::vector<Wall> walls = chamber_walls();
  const WallDistance concave(walls[0], 0.2), mantle(walls[1], 0.2);
  const WallPose rest;
  // Halfway along a segment, along its normal.
  const double dr = 1.263 - 1.140, dz = 0.5, l = std::hypot(dr, dz);
  for (const double h : {-0.15, -0.01, 0.0, 0.01, 0.1}) {
    const double r = (1.140 + 1.263) / 2 - h * dz / l, z = 1.25 + h * dr / l;
    CHECK(concave.at(rest, {r * 0.6, r * 0.8, z}) == Approx(h).margin(1e-12));
  }
  CHECK(concave.at(rest, {0, 0, 1}) == 0.2);  // cut off
  CHECK(mantle.at(rest, {0, 0, 1}) == -0.2);  // far inside the mantle
  CHECK(mantle.at(rest, {0.63 - 0.02, 0, 1.0}) < 0);
  CHECK(mantle.at(rest, {0.63 + 0.02, 0, 1.0}) > 0);
  CHECK(mantle.at(rest, {0, 0, 3.5}) == Approx(0.1).epsilon(1e-12));  // above its tip
  // A pose moves the wall: the point moves with it.
  const WallPose pose{{0.3, -0.2, 1}, rotation_about({0, 1, 0}, 0.1), {0, 0, 0}, {0, 0, 0}};
  const Vec3d p{1.1, 0.1, 1.0};
  CHECK(concave.at(pose, pose.origin + rotate(pose.orientation, p)) == Approx(concave.at(rest, p)).epsilon(1e-12));
}

TEST_CASE("Distances to a mesh equal a search through all triangles", "[feed]") {
  const Wall wall{"mantle", revolve(std::get<ProfileShape>(chamber_walls()[1].shape), 24), Fixed{}, 0};
  const auto& mesh = std::get<TriangleMesh>(wall.shape);
  const double reach = 0.1;
  const WallDistance distance(wall, reach);
  int near = 0;
  for (std::uint64_t k = 0; k < 2000; ++k) {
    const auto u = [k](std::uint32_t draw) { return uniform(2, Stream::place, k, draw); };
    const Vec3d p{2.4 * u(0) - 1.2, 2.4 * u(1) - 1.2, 4 * u(2) - 0.3};
    double nearest = reach;
    for (const auto& t : mesh.triangles) {
      const auto at = [&](Index v) { return mesh.vertices[static_cast<std::size_t>(v)]; };
      const Vec3d n = cross(at(t.y) - at(t.x), at(t.z) - at(t.x));
      if (!(norm2(n) > 0)) continue;
      nearest = std::min(nearest, std::sqrt(distance2_to_triangle({at(t.x), at(t.y), at(t.z), (1 / norm(n)) * n}, p)));
    }
    near += nearest < reach;
    CHECK(distance.at({}, p) == Approx(nearest).epsilon(1e-12));
  }
  CHECK(near > 100);
}

TEST_CASE("The distance to a triangle is the minimum of the distances to its points", "[feed]") {
  const Vec3d a{0.1, 0, 0.2}, b{1, 0.3, 0}, c{0.2, 0.9, 0.4}, n = cross(b - a, c - a);
  const FlatTriangle triangle{a, b, c, (1 / norm(n)) * n};
  const int cuts = 300;  // a grid of points: the nearest is off by less than the grid's spacing
  for (std::uint64_t k = 0; k < 50; ++k) {
    const auto u = [k](std::uint32_t draw) { return uniform(4, Stream::place, k, draw); };
    const Vec3d p{3 * u(0) - 1, 3 * u(1) - 1, 3 * u(2) - 1};
    double minimum = 1e9;
    for (int i = 0; i <= cuts; ++i) {
      for (int j = 0; i + j <= cuts; ++j) {
        minimum = std::min(minimum, norm(p - a - (i / double(cuts)) * (b - a) - (j / double(cuts)) * (c - a)));
      }
    }
    const double exact = std::sqrt(distance2_to_triangle(triangle, p));
    CHECK(exact <= minimum * (1 + 1e-12));
    CHECK(exact >= minimum - 1.0 / cuts);
  }
}
