// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/base/saved_state.hpp"
#include "core/math/vec3.hpp"

#include <cstdint>

namespace gyro {

enum class BreakMode : std::uint8_t { tension = 1, shear = 2 };

/// One broken bond.
struct Breakage {
  double time;
  BreakMode mode;
  Vec3d position;  ///< of its middle at the end of the window in which it broke [m]
  RockId rock;
  ParticleId i, j;
  double energy;  ///< elastic energy that the bond released [J]
};

/// What the rock did to one wall over the last window.
struct WallLoad {
  Vec3d force{0, 0, 0};   ///< mean over the window [N]
  Vec3d torque{0, 0, 0};  ///< mean, about the world's origin [N m]
  double work = 0;        ///< done by the wall on the rock in the window [J]
};

template <>
struct RowOf<WallLoad> : MadeOf<double> {};

/// What one particle did to one wall over a window, or the part of it between two rebuilds of the lists.
struct WallImpulse {
  Index wall;
  Vec3d centre;   ///< of the particle at the end, body frame of the wall [m]
  double radius;  ///< [m]
  Vec3d impulse;  ///< on the wall, body frame [N s]
  double slip;    ///< lost in sliding friction [J]
};

/// Energies of the scene [J]. The first four are states, the others add up since the start.
struct EnergyTerms {
  double kinetic = 0, potential = 0, contact_elastic = 0, bond_elastic = 0;
  double contact_damping = 0, friction = 0, bond_damping = 0, bond_breakage = 0;
  double wall_work = 0;
  double exchanged = 0;  ///< energy of what was put in less that of what was taken out

  /// What the balance lacks: zero up to rounding and the error of the time integration [J].
  double residual() const {
    return kinetic + potential + contact_elastic + bond_elastic + contact_damping + friction + bond_damping +
           bond_breakage - wall_work - exchanged;
  }
};

template <>
struct RowOf<EnergyTerms> : MadeOf<double> {};

/// Extremes for the guard: at the end of the last window and, if a step inside it passed one of the scene's
/// limits, those of the first such step as well. What peaks inside a window below the limits is not seen.
struct Extremes {
  bool finite = true;
  ParticleId culprit = 0;           ///< of the largest overlap, or the first that is not finite
  ParticleId partner = 0;           ///< of the largest overlap, if it is with a particle
  Index wall = none;                ///< of the largest overlap, if it is with a wall
  double overlap_ratio = 0;         ///< largest contact overlap / smaller radius [-]
  double speed_ratio = 0;           ///< largest v dt / R [-]
  ParticleId fastest = 0;           ///< of the largest speed_ratio
  double rotation = 0;              ///< largest spin x dt [rad]
  ParticleId fastest_rotating = 0;  ///< of the largest turn
  double bond_rotation = 0;         ///< largest turn of a bond's ends, only where it passed its limit [rad]
  ParticleId twisted = 0;           ///< one end of that bond
  double wall_step = 0;             ///< way of a wall's fastest place in a step / smallest radius, 0 for planes [-]
  Index fast_wall = none;           ///< of the largest wall_step
};

/// Counts of live things.
struct Counts {
  std::int64_t particles = 0, bonds_intact = 0, broken_tension = 0, broken_shear = 0;
  std::int64_t particle_steps = 0, bond_steps = 0, rebuilds = 0;
};

template <>
struct RowOf<Counts> : MadeOf<std::int64_t> {};

}  // namespace gyro
