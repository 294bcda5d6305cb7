// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mesh_frame.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <numbers>

using namespace gyro;

namespace {

const double right = std::numbers::pi / 2;

Vec3d framed_point(const Vec3d& point, const MeshFrame& frame) {
  return framed({{point}, {}}, frame).vertices[0];
}

void check_same(const Vec3d& a, const Vec3d& b) {
  CHECK(norm(a - b) < 1e-12);
}

}  // namespace

TEST_CASE("A mesh is scaled, then rotated about x, y, z, then shifted", "[geometry]") {
  check_same(framed_point({1, 2, 3}, {.scale = 0.001}), {0.001, 0.002, 0.003});
  check_same(framed_point({0, 1, 0}, {.rotate = {right, 0, 0}}), {0, 0, 1});   // y up becomes z up
  check_same(framed_point({1, 0, 0}, {.rotate = {0, -right, 0}}), {0, 0, 1});  // x up becomes z up
  // x after z would give (0, 0, 1).
  check_same(framed_point({1, 0, 0}, {.rotate = {right, 0, right}}), {0, 1, 0});
  check_same(framed_point({0, 100, 0}, {.scale = 0.01, .rotate = {right, 0, 0}, .shift = {1, 2, 3}}), {1, 2, 4});
}

TEST_CASE("A frame of defaults changes no bit", "[geometry]") {
  const Vec3d same = framed_point({-0.0, 1.0 / 3, 1e-300}, {});
  CHECK(std::signbit(same.x));
  CHECK(same.y == 1.0 / 3);
}

TEST_CASE("Extents are printed in the unit that fits them", "[geometry]") {
  const TriangleMesh small{{{-0.3, 0, 0}, {0.3, 0.25, 0.4}, {1e-14, 0, 0}}, {}};
  CHECK(to_string(extents_of(small)) == "x -300..300, y 0..250, z 0..400 mm");
  CHECK(to_string(extents_of(framed(small, {.scale = 1000}))) == "x -300..300, y 0..250, z 0..400 m");
  CHECK(extents_of(small).largest() == Approx(0.6));
}
