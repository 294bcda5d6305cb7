// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/make_dem.hpp"

#include <cmath>

// Small scenes that several tests share.

namespace gyro::test {

/// A scene of one rock material (index 0) and one wall material (index 1), both elastic and smooth
/// unless a test says otherwise.
inline Scene plain_scene(double dt) {
  Scene scene;
  scene.materials = {{"rock", 2600, 557e6, 0.35}, {"steel", 7800, 70e9, 0.3}};
  scene.pairs.assign(4, {0, 1, 0});
  scene.gravity = {0, 0, 0};
  scene.dt = dt;
  return scene;
}

inline NewRock sphere(ParticleId id, Vec3d x, Vec3d v, double radius, double density, Vec3d spin = {0, 0, 0}) {
  NewRock rock;
  rock.id = none;
  rock.particles.push_back({id, x, v, spin, radius, density});
  return rock;
}

/// The paper's bonds (Xiong et al. 2024, Table 1; units as corrected).
inline BondParameters paper_bonds() {
  BondParameters b;
  b.normal_stiffness = 1.67e12;
  b.shear_stiffness = 6.67e11;
  b.tensile_strength = 36e6;
  b.shear_strength = 24e6;
  b.damping = 0;
  return b;
}

/// Equal spheres on a cubic lattice of edge d, all nearest neighbours bonded.
inline NewRock lattice_rock(RockId id, int n, double d, double bond_radius, double density, ParticleId first = 0) {
  NewRock rock;
  rock.id = id;
  const auto number = [n](int i, int j, int k) { return (k * n + j) * n + i; };
  const double middle = 0.5 * (n - 1);
  for (int k = 0; k < n; ++k)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        rock.particles.push_back({first + static_cast<ParticleId>(number(i, j, k)),
                                  {d * (i - middle), d * (j - middle), d * (k - middle)},
                                  {0, 0, 0},
                                  {0, 0, 0},
                                  d / 2,
                                  density});
  // Bonds along one axis that start at even (odd) places share no particle: six colours.
  rock.colour_begin.push_back(0);
  for (int axis = 0; axis < 3; ++axis)
    for (int odd = 0; odd < 2; ++odd) {
      for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
          for (int i = 0; i < n; ++i) {
            const int along = axis == 0 ? i : axis == 1 ? j : k;
            if (along % 2 != odd || along + 1 >= n) continue;
            const int next = number(i + (axis == 0), j + (axis == 1), k + (axis == 2));
            rock.bonds.push_back({number(i, j, k), next, d, bond_radius, 1.0});
          }
      rock.colour_begin.push_back(static_cast<Index>(rock.bonds.size()));
    }
  return rock;
}

/// Gives a rock a rigid motion.
inline void set_rigid_motion(NewRock& rock, Vec3d velocity, Vec3d spin) {
  for (NewParticle& p : rock.particles) {
    p.velocity = velocity + cross(spin, p.position);
    p.spin = spin;
  }
}

/// Advances by a number of steps in windows of at most `window` steps.
inline void run(Dem& dem, double dt, std::int64_t& step, std::int64_t steps, int window = 500) {
  while (steps > 0) {
    const int n = static_cast<int>(std::min<std::int64_t>(steps, window));
    dem.advance({step, n, dt}, {});
    step += n;
    steps -= n;
  }
}

}  // namespace gyro::test
