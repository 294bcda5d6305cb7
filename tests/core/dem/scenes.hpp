// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/make_dem.hpp"
#include "core/math/random.hpp"

#include <algorithm>
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

inline NewRock sphere(ParticleId id, Vec3d x, Vec3d v, double radius, double density,
                      Vec3d angular_velocity = {0, 0, 0}) {
  NewRock rock;
  rock.id = none;
  rock.particles.push_back({id, x, v, angular_velocity, radius, density});
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
  // Bonds along one axis that start at even (odd) numbers share no particle: six colours.
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
inline void set_rigid_motion(NewRock& rock, Vec3d velocity, Vec3d angular_velocity) {
  for (NewParticle& p : rock.particles) {
    p.velocity = velocity + cross(angular_velocity, p.position);
    p.angular_velocity = angular_velocity;
  }
}

/// Walls of a box about the origin with half edges h, rock inside. Without `lid` it is open at the top.
inline std::vector<Wall> box(Vec3d h, bool lid = true) {
  std::vector<Wall> walls{{"left", PlaneShape{{-h.x, 0, 0}, {1, 0, 0}}, Fixed{}, 1},
                          {"right", PlaneShape{{h.x, 0, 0}, {-1, 0, 0}}, Fixed{}, 1},
                          {"front", PlaneShape{{0, -h.y, 0}, {0, 1, 0}}, Fixed{}, 1},
                          {"back", PlaneShape{{0, h.y, 0}, {0, -1, 0}}, Fixed{}, 1},
                          {"floor", PlaneShape{{0, 0, -h.z}, {0, 0, 1}}, Fixed{}, 1}};
  if (lid) walls.push_back({"lid", PlaneShape{{0, 0, h.z}, {0, 0, -1}}, Fixed{}, 1});
  return walls;
}

/// Number in (-1, 1), the same for the same arguments.
inline double random_number(std::uint64_t thing, std::uint32_t draw) {
  return 2 * uniform(11, Stream::place, thing, draw) - 1;
}
inline Vec3d random_vector(std::uint64_t thing, std::uint32_t draw) {
  return {random_number(thing, draw), random_number(thing, draw + 1), random_number(thing, draw + 2)};
}

/// nx x ny x nz spheres on a jittered lattice about the origin, with random velocities and angular velocities.
inline std::vector<NewRock> cloud(int nx, int ny, int nz, double spacing, double radius, double speed,
                                  ParticleId first = 0) {
  std::vector<NewRock> rocks;
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        const ParticleId id = first + static_cast<ParticleId>(rocks.size());
        const double r = radius * (0.9 + 0.1 * random_number(id, 9));
        const Vec3d place{i - 0.5 * (nx - 1), j - 0.5 * (ny - 1), k - 0.5 * (nz - 1)};
        rocks.push_back(sphere(id, spacing * place + (0.5 * spacing - radius) * random_vector(id, 0),
                               speed * random_vector(id, 3), r, 2600, (speed / radius) * random_vector(id, 6)));
      }
  return rocks;
}

/// Moves and rotates a rock as a whole; the spheres keep their ids, counted from `first` on.
inline NewRock placed(NewRock rock, RockId id, ParticleId first, Vec3d to, Quatd orientation = {1, 0, 0, 0}) {
  rock.id = id;
  for (NewParticle& p : rock.particles) {
    p.id += first;
    p.position = to + rotate(orientation, p.position);
    p.velocity = rotate(orientation, p.velocity);
    p.angular_velocity = rotate(orientation, p.angular_velocity);
  }
  return rock;
}

/// Strength factors between 0.4 and 1.6, by bond.
inline void scatter_strength(NewRock& rock) {
  for (std::size_t b = 0; b < rock.bonds.size(); ++b) rock.bonds[b].strength = 1 + 0.6 * random_number(b, 100);
}

/// Stiff and dense enough to be no part of a contact's compliance.
inline Material rigid() {
  return {"rigid", 1, 1e25, 0.3};
}
/// A material by Young's modulus.
inline Material elastic(double youngs, double nu, double density) {
  return {"rock", density, youngs / (2 * (1 + nu)), nu};
}
inline double sphere_mass(double radius, double density) {
  return density * 4.0 / 3 * M_PI * radius * radius * radius;
}
/// Duration and depth of an elastic normal impact on a rigid wall (Johnson 1985, ch. 11).
struct Impact {
  double depth, duration;
  Impact(const Material& m, double radius, double speed) {
    const double plane = 2 * m.shear_modulus * (1 + m.poisson_ratio) / (1 - m.poisson_ratio * m.poisson_ratio);
    depth = std::pow(15 * sphere_mass(radius, m.density) * speed * speed / (16 * plane * std::sqrt(radius)), 0.4);
    duration = 2.943275 * depth / speed;
  }
};

inline bool same(const Vec3d& a, const Vec3d& b) {
  return a.x == b.x && a.y == b.y && a.z == b.z;
}
/// Whether two snapshots agree to the bit.
inline bool same_bits(const ParticleSnapshot& a, const ParticleSnapshot& b) {
  if (a.id != b.id || a.rock != b.rock || a.fragment != b.fragment) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!same(a.position[k], b.position[k]) || !same(a.velocity[k], b.velocity[k]) ||
        !same(a.angular_velocity[k], b.angular_velocity[k]) || !same(a.force[k], b.force[k]))
      return false;
  return true;
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
