// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of curved walls against the exact surface (M10).
#include "app/verify/fixtures/held_sphere.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "core/math/random.hpp"
#include "core/walls/liners.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double radius = 0.05;
const Material rock = soft_rock();

/// The profile of a cone that opens upwards, divided into `levels` pieces; the rock is inside.
ProfileShape cone(int levels) {
  ProfileShape shape;
  for (int k = 0; k <= levels; ++k) shape.points.push_back({1 + 0.5 * k / levels, 1.2 * k / levels});
  return shape;
}

/// A hundred held spheres that overlap the cone by 10 to 14 % of their radius, away from its rims.
std::vector<NewRock> spheres() {
  std::vector<NewRock> all;
  const double slant = std::hypot(0.5, 1.2);
  for (int k = 0; k < 100; ++k) {
    const auto draw = [k](std::uint32_t n) { return uniform(5, Stream::place, static_cast<std::uint32_t>(k), n); };
    const double azimuth = 2 * pi * (k + 0.3 * draw(0)) / 100, z = 0.2 + (k % 2) * 0.45 + 0.15 * draw(1);
    const double from_wall = radius * (0.90 - 0.04 * draw(2)), r = 1 + 0.5 / 1.2 * z - from_wall * slant / 1.2;
    all.push_back(held_sphere(static_cast<ParticleId>(k), {r * std::cos(azimuth), r * std::sin(azimuth), z}, radius));
  }
  return all;
}

/// Forces towards the axis and upwards, summed over the spheres [N].
struct Push {
  double inward = 0, up = 0;
};

Push push_of(const Wall& wall, Precision precision) {
  Scene scene = scene_of(rock, rigid(), {0, 1, 0}, 1e-9);
  scene.walls = {wall};
  Stage stage(scene, precision);
  stage.insert(spheres());
  stage.advance(1);
  const ParticleSnapshot s = stage.dem().particles();
  Push push;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const Vec3d& x = s.position[k];
    push.inward -= (s.force[k].x * x.x + s.force[k].y * x.y) / std::hypot(x.x, x.y);
    push.up += s.force[k].z;
  }
  return push;
}

void cone_of_triangles(Recorder& out) {
  const Push exact = push_of({"cone", cone(1), Fixed{}, 1}, out.precision());
  double expected = 0;
  const double slant = std::hypot(0.5, 1.2);
  for (const NewRock& one : spheres()) {
    const Vec3d& x = one.particles[0].position;
    const double distance = (1 + 0.5 / 1.2 * x.z - std::hypot(x.x, x.y)) * 1.2 / slant;
    expected += hertz_force(rock, radius, radius - distance);
  }
  out.relative("profile-inward", exact.inward, expected * 1.2 / slant, {1e-9, 1e-6},
               "Hertz at the distance to the cone");
  out.relative("profile-up", exact.up, expected * 0.5 / slant, {1e-9, 1e-6}, "Hertz at the distance to the cone");
  double before = 0;
  for (const int fine : {1, 3, 10}) {  // about 1e3, 1e4 and 1e5 triangles
    const Push got = push_of({"cone", revolve(cone(8 * fine), 64 * fine), Fixed{}, 1}, out.precision());
    const double error = std::hypot(got.inward - exact.inward, got.up - exact.up) / std::hypot(exact.inward, exact.up);
    const std::string name = std::to_string(2 * 8 * 64 * fine * fine) + "-triangles";
    const double sagitta = 1.5 * 0.5 * std::pow(pi / (64 * fine), 2) / (0.10 * radius);  // over the smallest overlap
    out.absolute(name, error, 0, {sagitta, sagitta}, "the cone itself, within 3/2 of sagitta / overlap");
    if (before > 0) {
      const double order = std::log(before / error) / std::log(fine == 3 ? 3.0 : 10.0 / 3);
      out.within(name + "-order", order, 1.7, 2.3, "second order in the edge of the triangles");
    }
    before = error;
  }
}

}  // namespace

std::vector<Verification> mesh_tiling_cases() {
  return {
      {"mesh/m10-cone", cone_of_triangles},
  };
}

}  // namespace gyro::verify
