// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/liners.hpp"
#include "core/base/errors.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/surfaces/profile_surface.hpp"
#include "core/surfaces/touch_wall.hpp"
#include "tests/catch.hpp"

#include <numbers>

using namespace gyro;

namespace {

constexpr double pi = std::numbers::pi;
const double speed = 160 * 2 * pi / 60;  // eccentric [rad/s]
const double per_hour = 3600;

/// A chamber like that of a 62-75 gyratory crusher: mantle 1.905 m at the base, gape 1.575 m.
const std::vector<LinerRow> table{{0, .953, 1.094},   {.1, .915, 1.084},  {.2, .878, 1.077},  {.3, .843, 1.072},
                                  {.5, .776, 1.072},  {.75, .699, 1.095}, {1.0, .630, 1.140}, {1.5, .512, 1.263},
                                  {2.0, .424, 1.416}, {2.5, .349, 1.584}, {3.2, .244, 1.819}};
const LinerSetting setting{0.120, 0.0217, 4.2};

/// The curve behind the table: mantle half-angle 21 degrees falling to 8.5 at 2 m, nip angle a smoothstep
/// from 15 to 27.1 degrees at 1.1 m, integrated in steps of 25 mm.
std::vector<LinerRow> smooth_rows() {
  const double degree = pi / 180, step = 0.025;
  const auto lean = [&](double z) { return degree * (21 - 12.5 * std::min(z / 2, 1.0)); };
  const auto nip = [&](double z) {
    const double t = std::min(z / 1.1, 1.0);
    return degree * (15 + 12.1 * t * t * (3 - 2 * t));
  };
  std::vector<LinerRow> rows{{0, 0.9525, 0.9525 + 0.1417}};
  for (int i = 0; i < 128; ++i) {
    const double z = (i + 0.5) * step;
    rows.push_back({(i + 1) * step, rows.back().mantle_radius - step * std::tan(lean(z)),
                    rows.back().concave_radius + step * std::tan(nip(z) - lean(z))});
  }
  return rows;
}

std::vector<LinerRow> scaled(std::vector<LinerRow> rows, double factor) {
  for (LinerRow& row : rows) row = {factor * row.z, factor * row.mantle_radius, factor * row.concave_radius};
  return rows;
}

}  // namespace

TEST_CASE("liners: the closed side setting is met and the open side follows") {
  const Liners liners = make_liners(table, setting);
  const LinerReport report = measure(liners, speed, 9.81);
  CHECK(std::abs(report.closed_side_setting - 0.120) < 1e-6);
  // Twice the eccentricity, except for the tilt: it lifts the mantle's lip by e0 R / Lp = 5 mm on the closed side
  // and lowers it as much on the open one.
  CHECK(report.open_side_setting == Approx(0.1634).margin(1e-3));
  CHECK(report.throw_at_discharge == Approx(2 * 0.0217).margin(1e-3));
  CHECK(report.volume == Approx(15.5).margin(0.1));
  CHECK(std::abs(liners.motion.lift) < 0.01);
  // Another setting needs another lift; a narrower one is higher.
  LinerSetting narrow = setting;
  narrow.closed_side_setting = 0.1;
  const Liners narrower = make_liners(table, narrow);
  CHECK(narrower.motion.lift > liners.motion.lift);
  CHECK(std::abs(side_setting(narrower, narrower.motion.lift, true) - 0.1) < 1e-6);
}

TEST_CASE("liners: the setting is found again on the moving walls") {
  const Liners liners = make_liners(table, setting);
  const ProfileSurface concave(liners.concave);
  const ProfilePoint lip = liners.mantle.points[liners.mantle.points.size() - 2];
  double minimum = 1, min_opposite = 1;
  for (int turn = 0; turn < 8; ++turn) {
    const WallPose pose = gyration_pose(liners.motion, {pi / 4 * turn + 0.1, speed, 0.3 * turn, 0});
    for (int azimuth = 0; azimuth < 1440; ++azimuth)
      for (const ProfilePoint& on : {lip, ProfilePoint{0.915, 0.1}, ProfilePoint{0.878, 0.2}}) {
        const double a = 2 * pi * azimuth / 1440, r = on.r, z = on.z;
        // A sphere of 200 mm about a point of the mantle sees the concave at gap + 200 mm.
        const Vec3d p = to_world(pose, {r * std::cos(a), r * std::sin(a), z});
        const WallTouches t = touch_profile(concave.view(), {0, concave.view().count}, p, 0.2);
        if (t.count == 0) continue;
        minimum = std::min(minimum, t.touch[0].gap + 0.2);
        const double towards = std::atan2(p.y, p.x) - (pi / 4 * turn + 0.1);
        if (std::cos(towards) < -0.99999) min_opposite = std::min(min_opposite, t.touch[0].gap + 0.2);
      }
  }
  CHECK(minimum == Approx(0.120).margin(2e-6));
  CHECK(min_opposite == Approx(side_setting(liners, liners.motion.lift, false)).margin(1e-5));
}

TEST_CASE("liners: nip angles by height") {
  const LinerReport report = measure(make_liners(table, setting), speed, 9.81);
  const std::vector<double> degrees{15.0, 15.3, 16.1, 17.2, 20.2, 24.2, 26.8, 27.1, 27.1, 27.1, 27.1};
  REQUIRE(report.nip_angle.size() == degrees.size());
  // The table's radii are rounded to 1 mm: 0.6 degrees over its steps of 0.1 m, and chords are not tangents.
  for (std::size_t i = 0; i < degrees.size(); ++i)
    CHECK(report.nip_angle[i] * 180 / pi == Approx(degrees[i]).margin(1.2));
}

TEST_CASE("liners: slice capacity of the non-choking chamber") {
  const Liners liners = make_liners(smooth_rows(), setting);
  for (const double z : {0.2, 0.3, 0.4, 0.5, 0.75}) {
    const LinerLevel level = slice_at(liners, z, speed, 9.81);
    CHECK(level.capacity * per_hour > 1700);
    CHECK(level.capacity * per_hour < 1890);
  }
  // At the lip the slice falls freely for half a gyration.
  CHECK(slice_at(liners, 0.05, speed, 9.81).drop == Approx(0.1724).margin(1e-4));
  const LinerReport report = measure(liners, speed, 9.81);
  CHECK(report.choke_height == Approx(0.17).margin(0.04));
  CHECK(report.capacity * per_hour > 1600);
  CHECK(report.capacity * per_hour < 1890);
  CHECK(report.volume == Approx(15.5).margin(0.1));
  const LinerReport coarse = measure(make_liners(table, setting), speed, 9.81);
  CHECK(coarse.capacity == Approx(report.capacity).epsilon(0.03));
}

TEST_CASE("liners: a twin of one eighth scales by Froude's law") {
  const double f = 0.125;
  const LinerReport full = measure(make_liners(table, setting), speed, 9.81);
  const LinerReport twin =
      measure(make_liners(scaled(table, f), {f * 0.120, f * 0.0217, f * 4.2}), speed / std::sqrt(f), 9.81);
  CHECK(twin.closed_side_setting == Approx(f * full.closed_side_setting).epsilon(1e-8));
  CHECK(twin.volume == Approx(f * f * f * full.volume).epsilon(1e-8));
  CHECK(twin.capacity == Approx(std::pow(f, 2.5) * full.capacity).epsilon(1e-6));
}

TEST_CASE("liners: rock is on the proper side and cannot slip behind") {
  const Liners liners = make_liners(table, {0.120, 0.0217, 4.2, 0.3});
  const ProfileSurface concave(liners.concave), mantle(liners.mantle);
  const auto touch = [](const ProfileSurface& s, const Vec3d& c, double radius) {
    return touch_profile(s.view(), segments_near(s.view(), c, radius), c, radius);
  };
  const WallTouches out = touch(concave, {1.0, 0, 0.4}, 0.1);
  REQUIRE(out.count > 0);
  CHECK(out.touch[0].normal.x < -0.9);
  const WallTouches in = touch(mantle, {0.9, 0, 0.4}, 0.1);
  REQUIRE(in.count == 1);
  CHECK(in.touch[0].normal.x > 0.9);
  CHECK(touch(concave, {1.75, 0, 3.4}, 0.1).count == 1);  // collar
  CHECK(liners.mantle.points.front().r == 0);
  CHECK(liners.mantle.points.back().r == 0);
  CHECK(touch(mantle, {0.1, 0, 3.4}, 0.1).touch[0].normal.z > 0.7);
}

TEST_CASE("liners: the mesh of the mantle is closed, outward, and has its volume") {
  const Liners liners = make_liners(table, setting);
  const TriangleMesh mesh = revolve(liners.mantle, 240);
  double volume = 0;
  for (const Vec3<Index>& t : mesh.triangles) {
    const auto at = [&](Index i) { return mesh.vertices[static_cast<std::size_t>(i)]; };
    volume += dot(at(t.x), cross(at(t.y), at(t.z))) / 6;
  }
  double exact = 0;
  for (std::size_t i = 0; i + 1 < liners.mantle.points.size(); ++i) {
    const ProfilePoint &a = liners.mantle.points[i], &b = liners.mantle.points[i + 1];
    exact += pi / 3 * (a.r * a.r + a.r * b.r + b.r * b.r) * (a.z - b.z);
  }
  const double polygon = std::sin(2 * pi / 240) / (2 * pi / 240);
  CHECK(volume == Approx(exact * polygon).epsilon(1e-12));
  // Euler: a closed surface of the sphere's kind has V - E + F = 2, with E = 3 F / 2.
  const auto f = static_cast<long>(mesh.triangles.size());
  CHECK(f % 2 == 0);
  CHECK(static_cast<long>(mesh.vertices.size()) - 3 * f / 2 + f == 2);
}

TEST_CASE("liners: rows that do not form a chamber are refused") {
  CHECK_THROWS_AS(make_liners(std::vector<LinerRow>{{0, 1, 2}}, setting), BadInput);
  CHECK_THROWS_AS(make_liners(std::vector<LinerRow>{{0, 1, 0.9}, {1, 0.5, 2}}, setting), BadInput);
  CHECK_THROWS_AS(make_liners(std::vector<LinerRow>{{0, 1, 2}, {0, 0.5, 2}}, setting), BadInput);
  CHECK_THROWS_AS(make_liners(std::vector<LinerRow>{{0.1, 1, 2}, {1, 0.5, 2}}, setting), BadInput);
  CHECK_THROWS_AS(make_liners(table, {-0.1, 0.0217, 4.2}), BadInput);
  CHECK_THROWS_AS(make_liners(table, {5, 0.0217, 4.2}), BadInput);
  CHECK_THROWS_AS(make_liners(table, {0.12, 0.0217, 2}), BadInput);
  CHECK_THROWS_AS(revolve(make_liners(table, setting).mantle, 2), BadInput);
}
