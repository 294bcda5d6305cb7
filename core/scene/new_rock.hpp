// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/quat.hpp"

#include <vector>

namespace gyro {

/// A sphere to be put into the scene.
struct NewParticle {
  ParticleId id;
  Vec3d position, velocity, angular_velocity;
  double radius, density;
};

/// [kg]
inline double mass_of(const NewParticle& p) {
  return p.density * (4.0 / 3) * 3.14159265358979323846 * p.radius * p.radius * p.radius;
}

/// A bond to be put into the scene, between two particles of the same NewRock.
struct NewBond {
  Index i, j;       ///< positions in NewRock::particles, i < j
  double length;    ///< L0 [m]
  double radius;    ///< Rb [m]
  double strength;  ///< factor on both strengths [-]
};

/// A rock to be put into the scene. Bonds are grouped by colour as in RockTemplate.
struct NewRock {
  RockId id;
  std::vector<NewParticle> particles;
  std::vector<NewBond> bonds;
  std::vector<Index> colour_begin;
  int substeps =
      0;  ///< steps of its bonds in a step of the scene, during which other forces are held; 0: Scene::substeps
  Index load_table = none;        ///< in RigidLevel::tables; none: rows are made as needed by RigidLevel::response_of
                                  ///< if that is given, otherwise the rock never moves as a rigid body
  Quatd orientation{1, 0, 0, 0};  ///< from the frame of the load table to the world
};

}  // namespace gyro
