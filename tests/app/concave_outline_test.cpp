// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of the concave, which distinguishes the discharge opening from the rim, from a profile and from a mesh.
#include "app/assembly/walls.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"

using namespace gyro;

namespace {

const ProfileShape bell{{{0.14, 0}, {0.13, 0.05}, {0.18, 0.2}, {0.24, 0.4}}};

Wall concave(TriangleMesh mesh) {
  return {"concave", std::move(mesh), Fixed{}, 0};
}

}  // namespace

TEST_CASE("Profile and mesh of a concave have the same outline") {
  const std::vector<Wall> profile{{"mantle", bell, GyrationMotion{0.001, 1}, 0}, {"concave", bell, Fixed{}, 0}};
  const std::vector<Wall> mesh{concave(revolve(bell, 360))};
  const auto a = concave_outline(profile), b = concave_outline(mesh);
  REQUIRE(a);
  REQUIRE(b);
  CHECK(a->edge() == 0);
  CHECK(a->rim() == 0.4);
  CHECK(b->edge() == Approx(0).margin(1e-12));
  CHECK(b->rim() == Approx(0.4));
  for (const double z : {-0.1, 0.01, 0.05, 0.12, 0.3, 0.39}) {
    INFO(z);
    CHECK(b->radius(z) == Approx(a->radius(z)).epsilon(2e-4));
  }
  CHECK(a->radius(0.3) == Approx(0.21));
  CHECK(a->radius(-0.1) == Approx(1.1 * 0.14 + 0.1));
}

TEST_CASE("A bulge of a mesh belongs to the inside") {
  TriangleMesh mesh = revolve(bell, 360);
  for (Vec3d& v : mesh.vertices)
    if (v.x > 0) v.x *= 1.5;
  CHECK(concave_outline(std::vector<Wall>{concave(mesh)})->radius(0.3) == Approx(1.5 * 0.21).epsilon(1e-3));
}

TEST_CASE("There is no outline without a fixed wall called concave, nor for half a concave") {
  CHECK_FALSE(concave_outline({}));
  CHECK_FALSE(concave_outline(std::vector<Wall>{{"liner", bell, Fixed{}, 0}}));
  CHECK_FALSE(concave_outline(std::vector<Wall>{{"concave", bell, LinearMotion{{0, 0, 1}}, 0}}));
  CHECK_FALSE(concave_outline(std::vector<Wall>{{"concave", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 0}}));
  TriangleMesh half = revolve(bell, 360);
  std::erase_if(half.triangles, [&](const auto& t) { return half.vertices[static_cast<std::size_t>(t.x)].x > 0; });
  CHECK_THROWS_AS(concave_outline(std::vector<Wall>{concave(half)}), BadInput);
}
