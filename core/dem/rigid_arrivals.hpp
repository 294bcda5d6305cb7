// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/new_rock.hpp"
#include "core/state/bodies.hpp"
#include "core/state/fragment_labels.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

// Rocks that may move as rigid bodies, on their way into a scene. On the host.

namespace gyro {

/// Whether no bond is under load where the rock arrives: from this shape its particles and pieces may become rigid.
inline bool arrives_free_of_load(const NewRock& rock) {
  constexpr double rounding = 1e-9;
  return std::all_of(rock.bonds.begin(), rock.bonds.end(), [&](const NewBond& bond) {
    const Vec3d span = rock.particles[static_cast<std::size_t>(bond.j)].position -
                       rock.particles[static_cast<std::size_t>(bond.i)].position;
    return std::abs(norm(span) - bond.length) <= rounding * bond.length;
  });
}

/// Whether bonds hold all particles together.
inline bool arrives_in_one_piece(const NewRock& rock) {
  std::vector<Index> i, j;
  for (const NewBond& b : rock.bonds) i.push_back(b.i), j.push_back(b.j);
  const std::vector<Index> label = fragment_labels(static_cast<Index>(rock.particles.size()), i, j);
  return std::all_of(label.begin(), label.end(), [](Index first) { return first == 0; });
}

/// Whether all particles have the same velocity and none rotates.
inline bool arrives_without_rotation(const NewRock& rock) {
  const Vec3d& v = rock.particles.front().velocity;
  return std::all_of(rock.particles.begin(), rock.particles.end(), [&](const NewParticle& p) {
    return norm2(p.velocity - v) == 0 && norm2(p.angular_velocity) == 0;
  });
}

/// The rock as a rigid body that moves like its first particle and does not rotate.
inline Body body_of(const NewRock& rock) {
  Body body{};
  Vec3d middle{0, 0, 0};
  for (const NewParticle& p : rock.particles) {
    body.mass += mass_of(p);
    middle += mass_of(p) * p.position;
  }
  body.centre = (1 / body.mass) * middle;
  body.orientation = {1, 0, 0, 0};
  body.frame = rock.load_table == none ? Quatd{1, 0, 0, 0} : rock.orientation;  // rows of its own are in its own frame
  body.velocity = rock.particles.front().velocity;
  Symmetric inertia{{0, 0, 0}, {0, 0, 0}};
  for (const NewParticle& p : rock.particles) {
    inertia.add_point(mass_of(p), p.position - body.centre);
    inertia.diagonal += 0.4 * mass_of(p) * p.radius * p.radius * Vec3d{1, 1, 1};
  }
  const Symmetric inverted = inverse(inertia);
  body.diagonal = inverted.diagonal;
  body.rest = inverted.rest;
  return body;
}

/// Rows for the end of the columns of rigid rocks.
struct RigidArrivals {
  std::vector<Body> bodies;  ///< of each rock
  std::vector<Arm> arms;     ///< of each particle; zero outside of rocks

  void add(const NewRock& rock) {
    const bool is_rock = rock.id != none;
    if (is_rock) bodies.push_back(body_of(rock));
    for (const NewParticle& p : rock.particles)
      arms.push_back({is_rock ? p.position - bodies.back().centre : Vec3d{0, 0, 0}, p.radius});
  }
};

}  // namespace gyro
