// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/feed/feed.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {

constexpr double solid_density = 2600;  // kg/m3

/// A rough ball of spheres on a close-packed lattice. It represents a rock that its spheres fill to
/// 64 %, as templates are filled, so that the lattice cut off at the rim counts as a smaller rock.
inline RockTemplate ball_rock(double diameter, double ratio) {
  RockTemplate rock;
  rock.name = "ball";
  const double d = diameter / ratio, R = d / 2;
  const int n = static_cast<int>(ratio) + 2;
  double volume = 0;
  for (int k = -n; k <= n; ++k) {
    for (int j = -n; j <= n; ++j) {
      for (int i = -n; i <= n; ++i) {
        const double x = (2 * i + std::abs(j + k) % 2) * R;
        const double y = std::sqrt(3.0) * (j + std::abs(k) % 2 / 3.0) * R, z = 2 * std::sqrt(6.0) / 3 * k * R;
        const Vec3d c{x, y, z};
        if (norm(c) + R > diameter / 2) continue;
        rock.centres.push_back(c);
        rock.radii.push_back(R);
        volume += 4.0 / 3.0 * std::numbers::pi * R * R * R;
        rock.bounding_radius = std::max(rock.bounding_radius, norm(c) + R);
      }
    }
  }
  rock.solid_volume = volume / 0.64;
  rock.diameter = std::cbrt(6 * rock.solid_volume / std::numbers::pi);
  rock.particle_density = solid_density * rock.solid_volume / volume;
  for (Index k = 1; k < static_cast<Index>(rock.centres.size()); ++k) rock.bonds.push_back({k - 1, k, d, R / 2});
  rock.colour_begin = {0, static_cast<Index>(rock.bonds.size())};
  return rock;
}

/// One sphere as a rock.
inline RockTemplate sphere_rock(double radius) {
  RockTemplate rock;
  rock.name = "sphere";
  rock.centres = {{0, 0, 0}};
  rock.radii = {radius};
  rock.diameter = 2 * radius;
  rock.bounding_radius = radius;
  rock.solid_volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
  rock.particle_density = solid_density;
  return rock;
}

/// Concave and mantle of a 62-75, at rest, from the published proportions.
inline std::vector<Wall> chamber_walls() {
  constexpr double z[] = {0, .1, .2, .3, .5, .75, 1, 1.5, 2, 2.5, 3.2};
  constexpr double mantle[] = {.953, .915, .878, .843, .776, .699, .630, .512, .424, .349, .244};
  constexpr double concave[] = {1.094, 1.084, 1.077, 1.072, 1.072, 1.095, 1.140, 1.263, 1.416, 1.584, 1.819};
  ProfileShape outer, inner;
  for (std::size_t k = 0; k < std::size(z); ++k) {
    outer.points.push_back({concave[k], z[k]});
    inner.points.insert(inner.points.begin(), {mantle[k], z[k]});
  }
  inner.points.insert(inner.points.begin(), {0.0, 3.4});  // closed on top
  return {{"concave", outer, Fixed{}, 0}, {"mantle", inner, Fixed{}, 0}};
}

/// All particles of rocks as a snapshot, moved as a whole.
inline ParticleSnapshot snapshot_of(const std::vector<NewRock>& rocks, const Vec3d& shift = {0, 0, 0}) {
  ParticleSnapshot p;
  for (const NewRock& rock : rocks) {
    for (const NewParticle& n : rock.particles) {
      p.id.push_back(n.id);
      p.rock.push_back(rock.id);
      p.position.push_back(n.position + shift);
      p.radius.push_back(n.radius);
    }
  }
  return p;
}

/// Distance from a rock's first particle that holds all of it.
inline double extent(const NewRock& rock) {
  double reach = 0;
  for (const NewParticle& p : rock.particles) {
    reach = std::max(reach, norm(p.position - rock.particles[0].position) + p.radius);
  }
  return reach;
}

/// Smallest gap between spheres of different rocks, by comparing all pairs of all rocks that are
/// nearer than 0.1 m; 0.1 m if there are none.
inline double smallest_gap(const std::vector<NewRock>& rocks) {
  double smallest = 0.1;
  std::vector<double> reach_of;
  for (const NewRock& rock : rocks) reach_of.push_back(extent(rock));
  for (std::size_t a = 0; a < rocks.size(); ++a) {
    for (std::size_t b = a + 1; b < rocks.size(); ++b) {
      const double apart = norm(rocks[a].particles[0].position - rocks[b].particles[0].position);
      if (apart > reach_of[a] + reach_of[b] + smallest) continue;
      for (const NewParticle& p : rocks[a].particles) {
        for (const NewParticle& q : rocks[b].particles) {
          const double reach = p.radius + q.radius + smallest;
          const Vec3d d = p.position - q.position;
          if (norm2(d) < reach * reach) smallest = norm(d) - p.radius - q.radius;
        }
      }
    }
  }
  return smallest;
}

}  // namespace gyro
