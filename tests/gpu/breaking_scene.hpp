// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/dem/make_dem.hpp"

// One scene that uses everything the solver does: bonded rocks and loose spheres of three sizes fall
// into a turning cylinder with a mesh and a plane as its floor, break, are fed and taken out.

namespace gyro::test {

using namespace fixtures;

inline constexpr double breaking_dt = 4e-7;  // [s]

inline Scene breaking_scene() {
  Scene scene = plain_scene(breaking_dt);
  scene.pairs.assign(4, {0.4, 0.3, 0.01});
  scene.gravity = {0, 0, -9.81};
  scene.bonds = paper_bonds();
  scene.bonds->damping = 0.05;
  scene.bonds->tensile_strength = 4e6;
  scene.bonds->shear_strength = 3e6;
  scene.walls.push_back({"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1});
  scene.walls.push_back(
      {"shell", ProfileShape{{{0.07, -0.01}, {0.07, 0.1}, {0.09, 0.2}}}, RotationMotion{{0, 0, 1}, {0, 0, 0}, 20}, 1});
  scene.walls.push_back(
      {"wedge",
       TriangleMesh{{{-0.05, -0.06, 0}, {0.05, -0.06, 0}, {0.05, 0, 0.02}, {-0.05, 0, 0.02}, {0, 0.05, 0}},
                    {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}}},
       LinearMotion{{0, 0, 0.5}}, 1});
  return scene;
}

/// Two lattices of 4 x 4 x 4 spheres, one with sub-steps, and nine loose ones, ids from `first` on.
inline std::vector<NewRock> falling_rocks(RockId rock, ParticleId first, double height) {
  std::vector<NewRock> rocks;
  for (int k = 0; k < 2; ++k) {
    NewRock r = lattice(rock + k, 4, {0.01, 0.004}, first + 64 * static_cast<ParticleId>(k));
    for (NewParticle& p : r.particles)
      p.position = rotate(rotation_about({0.6, 0, 0.8}, 0.3 + k), p.position) + Vec3d{0.066 * k - 0.033, 0.004, height};
    add_rigid_motion(r, {0.5 - k, 0.2, -15}, {0, 0, 0});
    if (k == 1) r.substeps = 2;
    rocks.push_back(r);
  }
  for (int k = 0; k < 9; ++k)
    rocks.push_back(sphere(first + 128 + static_cast<ParticleId>(k),
                           {0.055 * (k % 3) - 0.055, 0.018 * (k / 3) - 0.02, height + 0.05},
                           {12.0 * (k % 3) - 12, 0, -12},
                           k % 3 == 0   ? 0.008
                           : k % 3 == 1 ? 0.004
                                        : 0.002,
                           2600, {0, 5, 0}));
  return rocks;
}

/// Everything that a scene reports.
struct Outcome {
  ParticleSnapshot particles;
  BondSnapshot bonds;
  std::vector<Breakage> breakages;
  std::vector<WallLoad> loads;
  std::vector<EnergyTerms> energies;
  std::vector<Extremes> extremes;
  Counts counts;
  Vec3d momentum;
};

/// Runs the scene: rocks fall, more rocks are fed, the lowest fragments are removed, the others continue.
inline Outcome break_rocks(Dem& dem) {
  Outcome out;
  std::int64_t step = 0;
  const auto go = [&](int windows) {
    for (int w = 0; w < windows; ++w) {
      run(dem, breaking_dt, step, 150, 150);
      out.energies.push_back(dem.energy());
      out.extremes.push_back(dem.extremes());
      for (const WallLoad& load : dem.wall_loads()) out.loads.push_back(load);
    }
  };
  dem.insert(falling_rocks(0, 0, 0.045));
  go(40);
  dem.insert(falling_rocks(2, 1000, 0.16));
  go(4);
  const ParticleSnapshot s = dem.particles();
  std::vector<ParticleId> leaving;
  for (std::size_t k = 0; k < s.size(); ++k)
    if (s.position[static_cast<std::size_t>(s.fragment[k])].z < 0.03) leaving.push_back(s.id[k]);
  dem.remove(leaving);
  go(4);
  out.particles = dem.particles();
  out.bonds = dem.bonds();
  out.breakages = dem.take_breakages();
  out.counts = dem.counts();
  out.momentum = dem.momentum();
  return out;
}

}  // namespace gyro::test
