// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/relaxation.hpp"
#include "app/bench/speed/start_state.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace gyro::bench {
namespace {

constexpr double smallest = 0.008, largest = 0.022;  // radii [m]
constexpr double fraction = 0.60;                    // of the volume that spheres fill
constexpr double usual_width = 0.8;                  // of the box [m]

std::string plane_at(const std::string& wall, const Vec3d& point) {
  char text[160];
  std::snprintf(text, sizeof text, "walls.%s.plane.point=[%.17g, %.17g, %.17g]", wall.c_str(), point.x, point.y,
                point.z);
  return text;
}

}  // namespace

double scene_scale(const StartRecipe& recipe) {
  return std::cbrt(1.0 * recipe.particles / usual_particles);
}

std::vector<double> mixed_radii(const StartRecipe& recipe) {
  std::vector<double> radii;
  for (int k = 0; k < recipe.particles; ++k)
    radii.push_back(smallest +
                    (largest - smallest) * uniform(recipe.seed, Stream::size, static_cast<std::uint64_t>(k), 0));
  return radii;
}

std::vector<Vec3d> scattered_velocities(const Vec3d& mean, const StartRecipe& recipe) {
  std::vector<Vec3d> velocities;
  for (int k = 0; k < recipe.particles; ++k) {
    const auto part = [&](std::uint32_t axis) {
      return 0.1 * (2 * uniform(recipe.seed, Stream::turn, static_cast<std::uint64_t>(k), axis) - 1);
    };
    velocities.push_back(mean + Vec3d{part(0), part(1), part(2)});
  }
  return velocities;
}

double volume_of(const std::vector<double>& radii) {
  double cubes = 0;
  for (const double r : radii) cubes += r * r * r;
  return 4 * std::numbers::pi / 3 * cubes;
}

void shrink_to_fit(const std::vector<Vec3d>& centres, std::vector<double>& radii) {
  const double factor = std::min(1.0, smallest_room(centres, radii)) * (1 - 1e-9);
  for (double& r : radii) r *= factor;
}

StartState loose_spheres(const StartRecipe& recipe) {
  StartState state;
  state.radii = mixed_radii(recipe);
  const double width = usual_width * scene_scale(recipe);
  const double height = volume_of(state.radii) / fraction / (width * width);
  state.centres = jittered_lattice(recipe.particles,
                                   {{0, 0, 0}, {width, width, height}, [](const Vec3d&) { return true; }}, recipe.seed);
  separate(state.centres, state.radii, [=](const Vec3d& x, double r) {
    return Vec3d{std::clamp(x.x, r, width - r), std::clamp(x.y, r, width - r), std::clamp(x.z, r, height - r)};
  });
  shrink_to_fit(state.centres, state.radii);
  state.velocities = scattered_velocities({1.0, 0.3, -1.0}, recipe);
  state.sizes = {{"width", width}, {"height", height}};
  state.overrides = {plane_at("right", {width, 0, 0}), plane_at("back", {0, width, 0})};
  return state;
}

}  // namespace gyro::bench
