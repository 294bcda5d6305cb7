// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/mesh_chamber.hpp"
#include "core/base/errors.hpp"
#include "core/walls/liners.hpp"
#include "core/walls/radial_sections.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <numbers>

using namespace gyro;

namespace {

constexpr double pi = std::numbers::pi;
const double speed = 160 * 2 * pi / 60, gravity = 9.81;

/// The 62-75 of liners_test.cpp, in pieces of 25 mm.
std::vector<LinerRow> smooth_rows() {
  const double degree = pi / 180, step = 0.025;
  std::vector<LinerRow> rows{{0, 0.9525, 0.9525 + 0.1417}};
  for (int i = 0; i < 128; ++i) {
    const double z = (i + 0.5) * step, t = std::min(z / 1.1, 1.0);
    const double lean = degree * (21 - 12.5 * std::min(z / 2, 1.0)), nip = degree * (15 + 12.1 * t * t * (3 - 2 * t));
    rows.push_back({(i + 1) * step, rows.back().mantle_radius - step * std::tan(lean),
                    rows.back().concave_radius + step * std::tan(nip - lean)});
  }
  return rows;
}

Liners profile() {
  return make_liners(smooth_rows(), {0.120, 0.0217, 4.2});
}

MeshLiners meshed(const Liners& liners, int sectors) {
  return {revolve(liners.concave, sectors), revolve(liners.mantle, sectors), liners.motion};
}

}  // namespace

TEST_CASE("The report of a meshed profile equals that of the profile", "[walls][chamber]") {
  const int sectors = 240;
  const Liners liners = profile();
  const LinerReport exact = measure(liners, speed, gravity);
  const MeshReport report = measure(meshed(liners, sectors), speed, gravity);
  CHECK(report.closed_side_setting == Approx(exact.closed_side_setting).margin(1e-4));
  CHECK(report.open_side_setting == Approx(exact.open_side_setting).margin(1e-4));
  CHECK(report.throw_at_discharge == Approx(exact.throw_at_discharge).margin(1e-4));
  for (const SideOfMeshes& side : report.sides) {
    CHECK(side.closed == Approx(exact.closed_side_setting).margin(1e-4));
    CHECK(side.open == Approx(exact.open_side_setting).margin(1e-4));
  }
  // Facets cut (2 pi / n)^2 / 6 off an area: 1.1e-4 for 240 sectors.
  CHECK(report.volume == Approx(exact.volume).epsilon(3e-4));
  CHECK(report.capacity == Approx(exact.capacity).epsilon(2e-3));
  CHECK(report.choke_height == Approx(exact.choke_height).margin(0.01));
  CHECK(report.bridged < 2e-3);
  REQUIRE(report.nip_angle.size() > 10);
  for (const MeshReport::NipAngle& nip : report.nip_angle) {
    const std::size_t row = static_cast<std::size_t>(std::lround(nip.z / 0.025));
    if (row == 0 || row + 1 >= exact.nip_angle.size()) continue;
    CAPTURE(nip.z);
    CHECK(nip.largest - nip.minimum < 1e-3);
    CHECK(nip.minimum == Approx(exact.nip_angle[row]).margin(0.3 * pi / 180));
  }
}

// A concave moved sideways by s is nearer to the mantle by s on one side: settings differ by 2 s around the ring,
// while the chamber's volume stays, because the area between two circles does not depend on their centres.
TEST_CASE("A concave beside the axis is measured in its position", "[walls][chamber]") {
  const double shift = 0.010;
  const Liners liners = profile();
  MeshLiners meshes = meshed(liners, 192);
  for (Vec3d& v : meshes.concave.vertices) v.x -= shift;
  const LinerReport exact = measure(liners, speed, gravity);
  const MeshReport report = measure(meshes, speed, gravity);
  // The mantle's lip is nearest to the concave along the concave's normal.
  const double lean = liners.rows[1].concave_radius - liners.rows[0].concave_radius;
  const double level = std::cos(std::atan2(lean, liners.rows[1].z));
  CHECK(exact.closed_side_setting - report.closed_side_setting == Approx(level * shift).epsilon(0.02));
  CHECK(report.open_side_setting - exact.open_side_setting == Approx(level * shift).epsilon(0.02));
  CHECK(report.throw_at_discharge == Approx(exact.throw_at_discharge).margin(3e-4));
  const auto narrowest = std::ranges::min_element(report.sides, {}, &SideOfMeshes::closed);
  CHECK(narrowest->azimuth == Approx(0).margin(1e-9));
  CHECK(report.volume == Approx(exact.volume).epsilon(1e-3));
}

// r = R (1 + e cos 2a): an area of pi R^2 (1 + e^2 / 2).
TEST_CASE("An oval concave has its own volume and sides", "[walls][chamber]") {
  const double oval = 0.01;
  const Liners liners = profile();
  MeshLiners meshes = meshed(liners, 192);
  for (Vec3d& v : meshes.concave.vertices) {
    const double factor = 1 + oval * std::cos(2 * std::atan2(v.y, v.x));
    v = {factor * v.x, factor * v.y, v.z};
  }
  const LinerReport exact = measure(liners, speed, gravity);
  const MeshReport report = measure(meshes, speed, gravity);
  const auto [narrow, wide] = std::ranges::minmax_element(report.sides, {}, &SideOfMeshes::closed);
  CHECK(std::abs(std::sin(narrow->azimuth)) == Approx(1).margin(1e-9));
  CHECK(std::abs(std::cos(wide->azimuth)) == Approx(1).margin(1e-9));
  CHECK(report.closed_side_setting < exact.closed_side_setting - 0.009);
  CHECK(report.open_side_setting > exact.open_side_setting + 0.009);
  CHECK(report.volume > exact.volume * (1 + 0.4e-4));
  CHECK(report.volume == Approx(exact.volume).epsilon(1e-3));
}

TEST_CASE("Holes in a liner are bridged and reported", "[walls][chamber]") {
  const Liners liners = profile();
  MeshLiners meshes = meshed(liners, 192);
  const MeshReport whole = measure(meshes, speed, gravity);
  std::erase_if(meshes.concave.triangles, [&](const Vec3<Index>& t) {
    const Vec3d& v = meshes.concave.vertices[static_cast<std::size_t>(t.x)];
    return v.z > 1 && v.z < 1.5 && std::abs(std::atan2(v.y, v.x)) < 0.3;
  });
  const MeshReport report = measure(meshes, speed, gravity);
  CHECK(report.bridged == Approx(0.6 / (2 * pi) * 0.5 / 3.2).epsilon(0.15));
  CHECK(report.volume == Approx(whole.volume).epsilon(1e-3));
  CHECK(report.capacity == Approx(whole.capacity).epsilon(1e-9));
}

TEST_CASE("A radial section takes the side that faces the rock", "[walls][chamber]") {
  const Liners liners = profile();
  TriangleMesh thick = revolve(liners.concave, 240);
  const std::size_t inner = thick.vertices.size();
  const auto count = static_cast<Index>(inner);
  for (std::size_t k = 0; k < inner; ++k) {
    const Vec3d v = thick.vertices[k];
    thick.vertices.push_back({1.1 * v.x, 1.1 * v.y, v.z});
  }
  for (const Vec3<Index>& t : std::vector(thick.triangles))
    thick.triangles.push_back({t.x + count, t.y + count, t.z + count});
  const HeightRange heights{0, 3.2};
  const RadialSections rock_side(thick, 0, heights, RadialSections::Face::innermost);
  const RadialSections back(thick, 0, heights, RadialSections::Face::outermost);
  for (const double z : {0.0, 0.31, 1.0, 3.2}) {
    CHECK(back.at(5, z) == Approx(1.1 * rock_side.at(5, z)).epsilon(1e-9));
    CHECK(rock_side.level(0) == 0);
  }
}

TEST_CASE("Meshes that do not form a chamber are refused", "[walls][chamber]") {
  const Liners liners = profile();
  MeshLiners meshes = meshed(liners, 48);
  CHECK_THROWS_AS(measure(meshes, 0, gravity), BadInput);
  std::erase_if(meshes.concave.triangles,
                [&](const Vec3<Index>& t) { return meshes.concave.vertices[static_cast<std::size_t>(t.x)].x < -0.5; });
  CHECK_THROWS_AS(measure(meshes, speed, gravity), BadInput);
  MeshLiners apart = meshed(liners, 48);
  for (Vec3d& v : apart.mantle.vertices) v.z -= 20;
  CHECK_THROWS_AS(measure(apart, speed, gravity), BadInput);
}

TEST_CASE("Gaps wider than a tenth of the concave's height are measured, too", "[walls][setting]") {
  const std::vector<LinerRow> wide{{0, 0.5, 0.68}, {1, 0.4, 0.9}};
  const Liners liners = make_liners(wide, {0.15, 0.01, 2});
  const MeshSetting setting =
      MeshGap(revolve(liners.mantle, 120), revolve(liners.concave, 120), liners.motion).measure(liners.motion.lift);
  CHECK(setting.closed == Approx(0.15).margin(3e-4));
  CHECK(setting.open == Approx(side_setting(liners, liners.motion.lift, false)).margin(3e-4));
}
