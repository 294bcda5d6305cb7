// SPDX-License-Identifier: GPL-3.0-or-later
// Drops a bonded rock onto a floor. Needs gyrosim::engine only.
#include "core/dem/make_dem.hpp"

#include <array>
#include <cstdio>

using namespace gyro;

/// A cube of side^3 touching spheres; neighbours along the axes are bonded.
NewRock make_cube(int side, double radius, double height, double speed) {
  NewRock rock{.id = 0, .particles = {}, .bonds = {}, .colour_begin = {}};
  const auto number = [&](const std::array<int, 3>& cell) {
    return Index((cell[2] * side + cell[1]) * side + cell[0]);
  };
  std::vector<std::array<int, 3>> cells;
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) cells.push_back({i, j, k});
  for (const auto& cell : cells)
    rock.particles.push_back({.id = ParticleId(number(cell)),
                              .position = {2 * radius * cell[0], 2 * radius * cell[1], height + 2 * radius * cell[2]},
                              .velocity = {0.3 * speed, 0, -speed},
                              .angular_velocity = {0, 0, 0},
                              .radius = radius,
                              .density = 2600});
  // Bonds of one colour share no particle, so that they are computed side by side: here every other one along an axis.
  for (int axis = 0; axis < 3; ++axis)
    for (int parity = 0; parity < 2; ++parity) {
      rock.colour_begin.push_back(Index(rock.bonds.size()));
      for (std::array<int, 3> cell : cells) {
        if (cell[axis] % 2 != parity || cell[axis] + 1 == side) continue;
        const Index i = number(cell);
        ++cell[axis];
        rock.bonds.push_back({.i = i, .j = number(cell), .length = 2 * radius, .radius = radius / 2, .strength = 1});
      }
    }
  rock.colour_begin.push_back(Index(rock.bonds.size()));
  return rock;
}

int main() {
  Scene scene;
  scene.materials = {{.name = "rock", .density = 2600, .shear_modulus = 139e6, .poisson_ratio = 0.35}};
  scene.pairs = {{.friction = 0.5, .restitution = 0.2}};
  scene.bonds = BondParameters{
      .normal_stiffness = 100e9, .shear_stiffness = 40e9, .tensile_strength = 2e6, .shear_strength = 1.4e6};
  scene.walls = {{.name = "floor", .shape = PlaneShape{{0, 0, 0}, {0, 0, 1}}, .motion = Fixed{}}};
  scene.dt = 2e-6;

  const auto dem = make_cpu_dem(scene, Precision::mixed, 1);
  dem->insert(std::array{make_cube(6, 0.004, 0.012, 6)});
  const std::int64_t bonds = dem->counts().bonds_intact;
  std::printf("time_ms,broken_bonds,kinetic_J,bond_elastic_J,lost_J,residual_J\n");
  for (Window window{.first_step = 0, .steps = 500, .dt = scene.dt}; window.first_step < 5000;
       window.first_step += window.steps) {
    dem->advance(window, {});
    const EnergyTerms e = dem->energy();
    std::printf("%g,%lld,%.4g,%.4g,%.4g,%.2g\n", window.end() * 1e3,
                static_cast<long long>(bonds - dem->counts().bonds_intact), e.kinetic, e.bond_elastic,
                e.contact_damping + e.friction + e.bond_damping + e.bond_breakage, e.residual());
  }
}
