// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surfaces/profile_surface.hpp"
#include "core/base/errors.hpp"
#include "core/math/random.hpp"
#include "core/surfaces/touch_wall.hpp"
#include "tests/catch.hpp"

#include <numbers>

using namespace gyro;

namespace {

constexpr double pi = std::numbers::pi;

WallTouches touch(const ProfileSurface& surface, const Vec3d& centre, double radius, double margin = 0) {
  const ProfileView view = surface.view();
  return touch_profile(view, segments_near(view, centre, radius + margin), centre, radius);
}

void check_same(const WallTouches& a, const WallTouches& b) {
  REQUIRE(a.count == b.count);
  for (int i = 0; i < a.count; ++i) {
    CHECK(a.touch[i].gap == b.touch[i].gap);
    CHECK(a.touch[i].weight == b.touch[i].weight);
    CHECK(norm(a.touch[i].normal - b.touch[i].normal) == 0);
  }
}

/// A chamber-like line with folds, overhang, a flat and a cone down to the axis.
const ProfileShape winding{{{0, 3.4}, {0.25, 3.2}, {0.4, 2.0}, {0.7, 0.8}, {0.6, 0.5}, {0.9, 0.4}, {0.9, 0}, {0, 0}}};

}  // namespace

TEST_CASE("A plane has its gap and normal") {
  const Vec3d n{0.6, 0, 0.8};
  const WallTouches t = touch_plane({1, 1, 1}, n, Vec3d{1, 1, 1} + 0.09 * n, 0.1);
  REQUIRE(t.count == 1);
  CHECK(t.touch[0].gap == Approx(-0.01).epsilon(1e-12));
  CHECK(touch_plane({0, 0, 0}, n, 0.11 * n, 0.1).count == 0);
  // The normal does not flip when the centre is behind the plane.
  CHECK(dot(touch_plane({0, 0, 0}, n, -0.02 * n, 0.1).touch[0].normal, n) == Approx(1));
}

TEST_CASE("A profile is a cylinder, from inside and from outside") {
  const ProfileSurface inside({{{1, -1}, {1, 1}}}), outside({{{1, 1}, {1, -1}}});
  const double azimuth = GENERATE(0.0, 0.4, 2.0, -1.3);
  const Vec3d out{std::cos(azimuth), std::sin(azimuth), 0};
  const WallTouches in = touch(inside, 0.92 * out + Vec3d{0, 0, 0.1}, 0.1);
  REQUIRE(in.count == 1);
  CHECK(in.touch[0].gap == Approx(-0.02).epsilon(1e-12));
  CHECK(norm(in.touch[0].normal + out) < 1e-15 * 4);
  const WallTouches ex = touch(outside, 1.08 * out, 0.1);
  REQUIRE(ex.count == 1);
  CHECK(ex.touch[0].gap == Approx(-0.02).epsilon(1e-12));
  CHECK(norm(ex.touch[0].normal - out) < 1e-15 * 4);
}

TEST_CASE("A profile is a cone, with exact gap and normal") {
  const double half = 0.35;  // half-angle; rock inside, apex at the origin
  const ProfileSurface cone({{{0, 0}, {2 * std::sin(half), 2 * std::cos(half)}}});
  const Vec3d centre{0.15, 0.2, 0.9};  // rho = 0.25
  const double distance = centre.z * std::sin(half) - 0.25 * std::cos(half);
  const WallTouches t = touch(cone, centre, 0.1);
  REQUIRE(t.count == 1);
  CHECK(t.touch[0].gap == Approx(distance - 0.1).epsilon(1e-12));
  CHECK(norm(t.touch[0].normal - Vec3d{-0.6 * std::cos(half), -0.8 * std::cos(half), std::sin(half)}) < 1e-14);
}

TEST_CASE("A profile is touched on its axis and at the tip of a cone") {
  const ProfileSurface tip({{{0, 1}, {1, 0}}});  // rock outside, tip upwards
  const WallTouches top = touch(tip, {0, 0, 1.09}, 0.1);
  REQUIRE(top.count == 1);
  CHECK(norm(top.touch[0].normal - Vec3d{0, 0, 1}) == 0);
  CHECK(top.touch[0].gap == Approx(-0.01).epsilon(1e-12));
  const ProfileSurface flat({{{0, 0}, {1, 0}}});  // rock above a disc
  const WallTouches disc = touch(flat, {0, 0, 0.09}, 0.1);
  REQUIRE(disc.count == 1);
  CHECK(disc.touch[0].normal.z == 1);
  const ProfileSurface tube({{{0.09, -1}, {0.09, 1}}});
  const WallTouches ring = touch(tube, {0, 0, 0}, 0.1);
  REQUIRE(ring.count == 1);
  CHECK(ring.touch[0].gap == Approx(-0.01).epsilon(1e-12));
  CHECK(std::isfinite(ring.touch[0].normal.x));
}

TEST_CASE("M3: around a convex edge the normal rotates, with one contact and a continuous gap") {
  const ProfileSurface edge({{{0, 0}, {1, 0}, {1, -1}}});  // flat top, rock above and outside
  double last = 0;
  bool first = true;
  for (int i = 0; i <= 2000; ++i) {
    const double angle = pi / 2 * i / 2000;  // the centre rolls around the edge, beyond both ends
    const double lead = 0.05 * (1 - 2.0 * i / 2000);
    const Vec3d centre{1 + 0.095 * std::sin(angle) - (lead > 0 ? lead : 0), 0,
                       0.095 * std::cos(angle) + (lead < 0 ? lead : 0)};
    const WallTouches t = touch(edge, centre, 0.1);
    REQUIRE(t.count == 1);
    CHECK(t.touch[0].weight == 1);
    if (!first) CHECK(std::abs(t.touch[0].gap - last) < 2e-4);
    last = t.touch[0].gap;
    first = false;
  }
}

TEST_CASE("M4: each side of a corner of a profile is a full contact") {
  const ProfileSurface floor_and_wall({{{0, 0}, {1, 0}, {1, 1}}});  // rock above the floor, inside the wall
  const WallTouches t = touch(floor_and_wall, {0.92, 0, 0.09}, 0.1);
  REQUIRE(t.count == 2);
  CHECK(t.touch[0].weight == 1);
  CHECK(t.touch[1].weight == 1);
  CHECK(t.touch[0].gap == Approx(-0.02).epsilon(1e-12));
  CHECK(t.touch[1].gap == Approx(-0.01).epsilon(1e-12));
  CHECK(t.touch[0].normal.x == -1);
  CHECK(t.touch[1].normal.z == 1);
}

TEST_CASE("H6: the normal of a profile does not flip when the centre passes through") {
  const ProfileSurface wall({{{1, -1}, {1, 0}, {1.1, 1}}});
  double last = touch(wall, {0.95, 0, 0}, 0.1).touch[0].gap;
  for (double x = 0.95; x < 1.05; x += 1e-4) {
    const WallTouches t = touch(wall, {x, 0, -0.3}, 0.1);
    REQUIRE(t.count == 1);
    CHECK(t.touch[0].normal.x == -1);
    CHECK(t.touch[0].gap < last + 1e-12);
    CHECK(t.touch[0].gap == Approx(0.9 - x).margin(1e-12));
    last = t.touch[0].gap;
  }
}

TEST_CASE("The segments of the last rebuild and all segments of a profile give the same bits") {
  const ProfileSurface surface(winding);
  const ProfileView view = surface.view();
  int touching = 0;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const auto draw = [&](std::uint32_t k) { return uniform(7, Stream::place, i, k); };
    const Vec3d centre{1.2 * draw(0), 0.4 * draw(1), -0.3 + 4 * draw(2)};
    const double radius = 0.01 + 0.2 * draw(3);
    const Vec3d moved = centre + 0.02 * Vec3d{draw(4), draw(5), -draw(6)};
    const WallTouches all = touch_profile(view, {0, view.count}, moved, radius);
    check_same(all, touch_profile(view, segments_near(view, centre, radius + 0.05), moved, radius));
    check_same(all, touch_profile(view, segments_near(view, moved, radius), moved, radius));
    touching += all.count > 0;
  }
  CHECK(touching > 1000);
}

TEST_CASE("Gaps to a profile are the true distance, by dense sampling") {
  const ProfileSurface surface(winding);
  for (std::uint32_t i = 0; i < 300; ++i) {
    const Vec3d centre{0.2 + uniform(3, Stream::place, i, 0), 0, -0.2 + 3.8 * uniform(3, Stream::place, i, 1)};
    const WallTouches t = touch(surface, centre, 0.2);
    if (t.count == 0 || t.touch[0].gap < -0.2) continue;
    double nearest = 1e9;
    for (std::size_t k = 0; k + 1 < winding.points.size(); ++k)
      for (int s = 0; s <= 20000; ++s) {
        const double a = s / 20000.0;
        const double r = (1 - a) * winding.points[k].r + a * winding.points[k + 1].r;
        const double z = (1 - a) * winding.points[k].z + a * winding.points[k + 1].z;
        nearest = std::min(nearest, std::hypot(centre.x - r, centre.z - z));
      }
    CHECK(t.touch[0].gap == Approx(nearest - 0.2).margin(1e-7));
  }
}

TEST_CASE("Profiles without length or with bad points are refused") {
  CHECK_THROWS_AS(ProfileSurface({{{1, 0}}}), BadInput);
  CHECK_THROWS_AS(ProfileSurface({{{1, 0}, {1, 0}}}), BadInput);
  CHECK_THROWS_AS(ProfileSurface({{{1, 0}, {-1, 1}}}), BadInput);
  CHECK_THROWS_AS(ProfileSurface({{{1, 0}, {NAN, 1}}}), BadInput);
}
