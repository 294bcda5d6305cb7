// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/base/hd.hpp"
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

  template <class F, class... B>
  static constexpr void for_each_field(F&& f, B&... b) {
    f("time", b.time...);
    f("mode", b.mode...);
    f("position", b.position...);
    f("rock", b.rock...);
    f("i", b.i...);
    f("j", b.j...);
    f("energy", b.energy...);
  }
};
static_assert(declares_every_field<Breakage>);

/// What the rock did to one wall over the last window.
struct WallLoad {
  Vec3d force{0, 0, 0};   ///< mean over the window [N]
  Vec3d torque{0, 0, 0};  ///< mean, about the world's origin [N m]
  double work = 0;        ///< done by the wall on the rock in the window [J]

  template <class F, class... L>
  static constexpr void for_each_field(F&& f, L&... l) {
    f("force", l.force...);
    f("torque", l.torque...);
    f("work", l.work...);
  }
};
static_assert(declares_every_field<WallLoad>);

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
  double switched =
      0;  ///< lost where rocks became rigid bodies, elastic energy and inner motion, and where bonds were let go

  /// Energy balance residual: zero up to rounding and the error of the time integration [J].
  double residual() const {
    return kinetic + potential + contact_elastic + bond_elastic + contact_damping + friction + bond_damping +
           bond_breakage + switched - wall_work - exchanged;
  }

  template <class F, class... E>
  static constexpr void for_each_field(F&& f, E&... e) {
    f("kinetic", e.kinetic...);
    f("potential", e.potential...);
    f("contact_elastic", e.contact_elastic...);
    f("bond_elastic", e.bond_elastic...);
    f("contact_damping", e.contact_damping...);
    f("friction", e.friction...);
    f("bond_damping", e.bond_damping...);
    f("bond_breakage", e.bond_breakage...);
    f("wall_work", e.wall_work...);
    f("exchanged", e.exchanged...);
    f("switched", e.switched...);
  }
};
static_assert(declares_every_field<EnergyTerms>);

/// Extremes for the guard: at the end of the last window and, if a step inside it passed one of the scene's
/// limits, those of the first such step as well. Peaks inside a window below the limits are not seen.
struct Extremes {
  bool finite = true;
  ParticleId culprit = 0;           ///< of the largest overlap, or the first that is not finite
  ParticleId partner = 0;           ///< of the largest overlap, if it is with a particle
  Index wall = none;                ///< of the largest overlap, if it is with a wall
  double overlap_ratio = 0;         ///< largest contact overlap / smaller radius [-]
  double speed_ratio = 0;           ///< largest v dt / R [-]
  ParticleId fastest = 0;           ///< of the largest speed_ratio
  double rotation = 0;              ///< largest angular velocity x dt [rad]
  ParticleId fastest_rotating = 0;  ///< of the largest rotation
  double bond_rotation = 0;         ///< largest rotation of a bond's ends, only where it passed its limit [rad]
  ParticleId twisted = 0;           ///< one end of that bond
  double contact_step = 0;          ///< largest step / stability limit of what a particle touches [-]
  ParticleId crowded = 0;           ///< of the largest contact_step
  std::int32_t crowd = 0;           ///< number of its contacts
  double wall_step = 0;    ///< largest distance that a wall moves in a step / smallest radius, 0 for planes [-]
  Index fast_wall = none;  ///< of the largest wall_step
};

/// What the ledger and the guard look at when a window is closed.
struct Balance {
  EnergyTerms energy;
  Extremes extremes;
  Vec3d momentum;  ///< [kg m/s]
};

/// Counts of live things.
struct Counts {
  std::int64_t particles = 0, bonds_intact = 0, broken_tension = 0, broken_shear = 0;
  std::int64_t particle_steps = 0, bond_steps = 0, rebuilds = 0;
  std::int64_t rigid_particles = 0;  ///< in rocks that move as rigid bodies

  template <class F, class... C>
  static constexpr void for_each_field(F&& f, C&... c) {
    f("particles", c.particles...);
    f("bonds_intact", c.bonds_intact...);
    f("broken_tension", c.broken_tension...);
    f("broken_shear", c.broken_shear...);
    f("particle_steps", c.particle_steps...);
    f("bond_steps", c.bond_steps...);
    f("rebuilds", c.rebuilds...);
    f("rigid_particles", c.rigid_particles...);
  }
};
static_assert(declares_every_field<Counts>);

}  // namespace gyro
