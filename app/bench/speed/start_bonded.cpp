// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/relaxation.hpp"
#include "app/bench/speed/start_state.hpp"
#include "core/math/random.hpp"
#include "core/rocks/packing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace gyro::bench {
namespace {

constexpr double radius = 0.010;         // [m]
constexpr double bond_gap = 0.15;        // of the surfaces that are bonded / radius [-]
constexpr double fraction = 0.57;        // of the cylinder that spheres fill before they are moved apart
constexpr double usual_cylinder = 0.25;  // radius of the cylinder [m]
constexpr int rock_size = 136;           // particles of a rock

/// Plates that touch the lowest and the highest sphere.
void add_plates(StartState& state) {
  const auto [low, high] = std::ranges::minmax_element(state.centres, {}, &Vec3d::z);
  state.sizes.insert(state.sizes.end(), {{"bottom", low->z - radius}, {"top", high->z + radius}});
  for (const auto& [wall, z] : state.sizes) {
    char text[80];
    std::snprintf(text, sizeof text, "walls.%s.plane.point=[0, 0, %.17g]", wall.c_str(), z);
    state.overrides.emplace_back(text);
  }
}

/// The spheres of a rock around the origin: those nearest to the middle of a jammed packing, which is widened until
/// nothing overlaps.
std::vector<Vec3d> one_rock() {
  const Packing& packing = rock_packing();
  const Vec3d middle{0.5 * packing.side, 0.5 * packing.side, 0.5 * packing.side};
  std::vector<Vec3d> centres;
  for (const Vec3d& x : packing.centres) centres.push_back(radius * (x - middle));
  std::ranges::sort(centres, {}, [](const Vec3d& x) { return norm2(x); });
  centres.resize(rock_size);
  const double room = smallest_room(centres, std::vector<double>(centres.size(), radius));
  for (Vec3d& x : centres) x = (1 / std::min(1.0, room)) * x;
  return centres;
}

}  // namespace

StartState bonded_cylinder(const StartRecipe& recipe) {
  StartState state;
  state.radii.assign(static_cast<std::size_t>(recipe.particles), radius);
  const double across = usual_cylinder * scene_scale(recipe);
  const double height = volume_of(state.radii) / fraction / (std::numbers::pi * across * across);
  const auto inside = [=](const Vec3d& x) { return std::hypot(x.x, x.y) < across - 0.3 * radius; };
  state.centres =
      jittered_lattice(recipe.particles, {{-across, -across, 0}, {across, across, height}, inside}, recipe.seed);
  separate(state.centres, state.radii, [=](const Vec3d& x, double r) {
    const double inwards = std::min(1.0, (across - r) / std::max(std::hypot(x.x, x.y), 1e-12));
    return Vec3d{inwards * x.x, inwards * x.y, std::clamp(x.z, r, height - r)};
  });
  const double growth = 1 / std::min(1.0, smallest_room(state.centres, state.radii));
  for (Vec3d& x : state.centres) x = growth * x;
  state.bonds = close_pairs(state.centres, state.radii, bond_gap * radius);
  add_plates(state);
  return state;
}

StartState bonded_rocks(const StartRecipe& recipe) {
  const std::vector<Vec3d> rock = one_rock();
  const std::vector<ClosePair> bonds = close_pairs(rock, std::vector<double>(rock.size(), radius), bond_gap * radius);
  double reach = 0;
  for (const Vec3d& x : rock) reach = std::max(reach, std::hypot(x.x, x.y) + radius);
  const double pitch = 2 * reach + 0.1 * radius;
  const int rocks = std::max(1, static_cast<int>(std::lround(1.0 * recipe.particles / rock_size)));
  const int columns = static_cast<int>(std::ceil(std::sqrt(1.0 * rocks)));
  StartState state;
  for (int n = 0; n < rocks; ++n) {
    const Vec3d at{pitch * (n % columns), pitch * (n / columns), 0};
    const double turn = 2 * std::numbers::pi * uniform(recipe.seed, Stream::turn, static_cast<std::uint64_t>(n), 0);
    const auto first = static_cast<Index>(state.centres.size());
    for (const Vec3d& x : rock) {
      state.centres.push_back(
          at + Vec3d{std::cos(turn) * x.x - std::sin(turn) * x.y, std::sin(turn) * x.x + std::cos(turn) * x.y, x.z});
    }
    for (const auto& [i, j] : bonds) state.bonds.push_back({first + i, first + j});
  }
  state.radii.assign(state.centres.size(), radius);
  add_plates(state);
  return state;
}

}  // namespace gyro::bench
