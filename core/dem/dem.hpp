// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/dem/scene.hpp"
#include "core/dem/window.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// A sphere to be put into the scene.
struct NewParticle {
  ParticleId id;
  Vec3d position, velocity, spin;
  double radius, density;
};

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
};

/// The particles of a scene, one row each, in order of id.
struct ParticleSnapshot {
  std::vector<ParticleId> id;
  std::vector<RockId> rock;
  std::vector<Index> fragment;  ///< row of the first particle of the same fragment
  std::vector<Vec3d> position, velocity, spin;
  std::vector<Vec3d> force;  ///< sum of contact, wall and bond forces, without gravity [N]
  std::vector<double> radius, mass;
  std::size_t size() const { return id.size(); }
};

/// The intact bonds of a scene.
struct BondSnapshot {
  std::vector<Index> i, j;           ///< rows in the particle snapshot
  std::vector<double> normal_force;  ///< tension positive [N]
  std::vector<double> stress_ratio;  ///< larger of tension/strength and shear/strength [-]
  std::vector<double> radius;        ///< [m]
  std::size_t size() const { return i.size(); }
};

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
  Vec3d moment{0, 0, 0};  ///< mean, about the world's origin [N m]
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
  ParticleId culprit = 0;    ///< of the largest overlap, or the first that is not finite
  ParticleId partner = 0;    ///< of the largest overlap, if it is with a particle
  Index wall = none;         ///< of the largest overlap, if it is with a wall
  double overlap_ratio = 0;  ///< largest contact overlap / smaller radius [-]
  double speed_ratio = 0;    ///< largest v dt / R [-]
  ParticleId fastest = 0;    ///< of the largest speed_ratio
  double turn = 0;           ///< largest spin x dt [rad]
  ParticleId spinner = 0;    ///< of the largest turn
  double bond_turn = 0;      ///< largest turn of a bond's ends, only where it passed its limit [rad]
  ParticleId twisted = 0;    ///< one end of that bond
  double wall_step = 0;      ///< way of a wall's fastest place in a step / smallest radius, 0 for planes [-]
  Index fast_wall = none;    ///< of the largest wall_step
};

/// Counts of live things.
struct Counts {
  std::int64_t particles = 0, bonds_intact = 0, broken_tension = 0, broken_shear = 0;
  std::int64_t particle_steps = 0, bond_steps = 0, rebuilds = 0;
};

template <>
struct RowOf<Counts> : MadeOf<std::int64_t> {};

/// A discrete element scene on one executor and in one precision. Calls are cheap at the
/// scale of a window and virtual only there.
class Dem {
 public:
  virtual ~Dem() = default;
  /// Adds rocks between windows. Ids must be new.
  virtual void insert(std::span<const NewRock> rocks) = 0;
  /// Removes particles between windows. @param ids particles, whole fragments.
  virtual void remove(std::span<const ParticleId> ids) = 0;
  /// Where the walls stand now. One per wall; before the first window as at time 0.
  virtual std::vector<WallPose> wall_poses() const = 0;
  /// Wall seconds by phase of the step, since the start.
  virtual std::vector<std::pair<std::string, double>> phase_seconds() const = 0;
  /// Advances by one window; every wall moves as its motion says, gyrating ones along `path`.
  /// @throws StoppedByGuard if memory for contacts cannot be had
  virtual void advance(const Window& window, const MantlePath& path) = 0;

  virtual std::vector<WallLoad> wall_loads() const = 0;  ///< of the last window, one per wall
  virtual EnergyTerms energy() const = 0;                ///< now
  virtual Extremes extremes() const = 0;                 ///< now
  virtual Counts counts() const = 0;
  virtual Vec3d momentum() const = 0;                  ///< [kg m/s]
  virtual ParticleSnapshot particles() const = 0;      ///< now, fragments labelled
  virtual BondSnapshot bonds() const = 0;              ///< now
  virtual std::vector<Breakage> take_breakages() = 0;  ///< since the last call, ordered by time, i, j
  /// Since the last call; nothing unless Scene::wall_impulses. Their sum is that of the walls' loads, but for half of
  /// the last step's, which those count in the next window.
  virtual std::vector<WallImpulse> take_wall_impulses() = 0;

  /// What must be kept to go on bit for bit, between windows; on any executor, in this precision.
  virtual SavedState save() const = 0;
  /// Replaces everything by what a scene of the same case has saved. @throws BadInput as SavedState::get
  virtual void restore(const SavedState& saved) = 0;
};

}  // namespace gyro
