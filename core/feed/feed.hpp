// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem.hpp"
#include "core/feed/region.hpp"
#include "core/rocks/rock_template.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gyro {

/// Factor on both strengths of a bond. @param bond  index in the rock's template
using BondStrength = std::function<double(RockId rock, Index bond)>;

/// One rock at a given place, at rest at t = 0.
struct FixedRock {
  Index rock;  ///< in the library
  Vec3d position;
  Quatd turn{1, 0, 0, 0};
};

/// What is fed, where and when.
struct FeedPlan {
  double initial = 0;            ///< mass in the chamber at t = 0 [kg]
  double batch = 0;              ///< mass owed at once at `start` [kg]
  double rate = 0;               ///< from `start` on [kg/s]
  double start = 0;              ///< [s]
  std::vector<FixedRock> fixed;  ///< placed before all others
  std::optional<Region> charge;  ///< where the initial charge goes; needed with `initial`
  std::optional<Region> entry;   ///< where batch and rate enter; needed with them
  double clearance = 1e-4;       ///< least gap to other spheres and walls at insertion [m]
  double retry = 0.01;           ///< time between two attempts while the entry is full [s]
  int places = 24;               ///< random places tried for each rock
  int improvements = 48;         ///< small moves tried from the best of them
  std::uint64_t seed = 0;
  RockId first_rock = 0;          ///< numbers given so far to rocks
  ParticleId first_particle = 0;  ///< and to particles, by others
};

/// What has been fed. Counts are exact, the mass follows from them.
struct FeedAccount {
  std::int64_t rocks = 0, particles = 0, bonds = 0;
  double mass = 0;           ///< [kg]
  std::int64_t delayed = 0;  ///< rocks that found no room when they were due
  double waiting = 0;        ///< mass that is owed and has not found room [kg], at the last call of `due`
};

/// The feed: draws rocks of a library and places them without overlap. Every rock's kind,
/// turn and place are functions of (seed, rock number, what is already there).
class Feed {
 public:
  /// Everything that a checkpoint must keep.
  struct State {
    std::vector<std::int64_t> of_template;  ///< rocks fed so far, by template
    std::int64_t rocks = 0, particles = 0;
    std::int64_t delayed = 0;
    double waiting = 0;
    double next_try = 0;      ///< [s]
    bool next_waits = false;  ///< the next rock has been counted as delayed
  };

  /// @param library   kept by reference
  /// @param strength  empty: every bond has strength 1
  /// @throws BadInput if the plan cannot be carried out: no rocks, no region, a rock larger than its region
  Feed(const RockLibrary& library, FeedPlan plan, std::vector<Wall> walls, BondStrength strength = {});

  /// Fixed rocks and the initial charge. Each rock takes the lowest of many random places,
  /// so the charge is dense; its mass is the asked one to half a rock.
  /// @param poses    of the walls at t = 0
  /// @param present  particles that are already there
  /// @throws BadInput if the charge does not fit
  std::vector<NewRock> initial(std::span<const WallPose> poses, const ParticleSnapshot& present = {});

  /// Whether `due` may have something to give: cheap, for every window.
  bool wants(double time) const;

  /// Rocks whose mass is owed at this time and that find room. One without room waits and
  /// is never dropped.
  /// @param poses  of the walls now
  std::vector<NewRock> due(double time, std::span<const WallPose> poses, const ParticleSnapshot& present);

  /// Mass that should have been fed by this time [kg].
  double owed(double time) const;
  FeedAccount account() const;
  const State& state() const { return state_; }
  void restore(State state) { state_ = std::move(state); }

 private:
  double fed_mass() const;
  NewRock instance(Index kind, const Vec3d& position, const Quatd& turn);

  const RockLibrary& library_;
  FeedPlan plan_;
  std::vector<Wall> walls_;
  BondStrength strength_;
  std::vector<double> masses_;  ///< of the templates [kg]
  State state_;
};

}  // namespace gyro
