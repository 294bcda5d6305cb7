// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/feed/placement.hpp"
#include "core/feed/region.hpp"
#include "core/rocks/rock_template.hpp"
#include "core/scene/dem.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace gyro {

/// Factor on both strengths of the bond between two particles of a rock.
using BondStrength = std::function<double(RockId rock, ParticleId i, ParticleId j)>;

/// One rock at a given position, at rest at t = 0.
struct FixedRock {
  Index rock;                     ///< number in the library
  Vec3d position;                 ///< of the centre of mass [m]
  Quatd orientation{1, 0, 0, 0};  ///< from the frame of the template to the world
};

/// Masses, regions and times of the feed. All rocks start at rest.
struct FeedPlan {
  double initial = 0;            ///< mass in the chamber at t = 0 [kg]
  double batch = 0;              ///< mass owed at once at `start` [kg]
  double rate = 0;               ///< from `start` on [kg/s]
  double start = 0;              ///< time at which batch and rate begin [s]
  std::vector<FixedRock> fixed;  ///< placed before all others, in addition to the masses above
  std::optional<Region> charge;  ///< region of the initial charge; required with `initial`
  std::optional<Region> entry;   ///< region where batch and rate enter; required with them
  double clearance = 1e-4;       ///< minimum gap to other spheres and walls at insertion [m]
  double retry = 0.01;           ///< time between two attempts while the entry is full [s]
  int positions = 24;            ///< random positions tried for each rock
  int improvements = 48;         ///< small moves tried from the best of them, initial charge only
  std::uint64_t seed = 0;
  RockId first_rock = 0;          ///< number of the first rock of the feed
  ParticleId first_particle = 0;  ///< id of the first particle of the feed
};

/// Rocks and mass fed so far. Counts are exact; the mass is computed from them.
struct FeedAccount {
  std::int64_t rocks = 0, particles = 0, bonds = 0;
  double mass = 0;           ///< [kg]
  std::int64_t delayed = 0;  ///< rocks for which there was no room when they were due
  double waiting = 0;        ///< mass that was owed at the last call of `due` and had no room [kg]
};

/// The feed: draws rocks of a library and inserts them without overlap. Template, orientation and position of a rock
/// are functions of (seed, rock number, particles present).
///
/// Each template of the library stands for an equal share of the mass of the feed: templates are
/// drawn with probability proportional to 1/mass. The mass fed is within half a rock of the mass owed.
class Feed {
 public:
  /// Everything that a checkpoint keeps.
  struct State {
    std::vector<std::int64_t> of_template;  ///< rocks fed so far, by template
    std::int64_t rocks = 0, particles = 0;
    double charged = 0;  ///< mass of fixed rocks and initial charge [kg]
    std::int64_t delayed = 0;
    double waiting = 0;          ///< [kg]
    double next_try = 0;         ///< [s]
    std::uint32_t attempts = 0;  ///< failed ones for the next rock

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("of_template", s.of_template...);
      f("rocks", s.rocks...);
      f("particles", s.particles...);
      f("charged", s.charged...);
      f("delayed", s.delayed...);
      f("waiting", s.waiting...);
      f("next_try", s.next_try...);
      f("attempts", s.attempts...);
    }
  };

  /// @param library   must outlive the feed
  /// @param walls     of the scene
  /// @param strength  empty: the factor is 1 for every bond
  /// @throws BadInput if the plan is impossible: no rocks, no region, rocks larger than the region
  Feed(const RockLibrary& library, FeedPlan plan, std::span<const Wall> walls, BondStrength strength = {});

  /// Fixed rocks and the initial charge. Each rock of the charge gets the lowest of many positions.
  /// @param poses    of the walls at t = 0
  /// @param present  particles in the scene
  /// @throws BadInput if a fixed rock overlaps something or the charge does not fit
  std::vector<NewRock> initial(std::span<const WallPose> poses, const ParticleSnapshot& present = {});

  /// Whether `due` may return rocks at this time [s]. It is cheap enough for every window.
  bool wants(double time) const;

  /// Rocks whose mass is owed at this time [s] and for which there is room. A rock without room waits and is tried
  /// again every `retry`. No rock is dropped, and rocks keep their order.
  /// @param poses  of the walls now
  std::vector<NewRock> due(double time, std::span<const WallPose> poses, const ParticleSnapshot& present);

  /// Mass that batch and rate should have fed by this time [kg].
  double owed(double time) const;
  FeedAccount account() const;
  /// Mass of a rock of this template [kg].
  double template_mass(Index kind) const { return masses_[static_cast<std::size_t>(kind)]; }
  const State& state() const { return state_; }
  void restore(State state) { state_ = std::move(state); }

 private:
  void check_plan() const;
  void check_fixed(const FixedRock& fixed, const Bed& bed) const;
  double fed_mass() const;
  Index next_kind() const;
  Bed bed_of(const ParticleSnapshot& present, const FeedRegion* near) const;
  std::optional<NewRock> placed(const FeedRegion& region, Bed& bed, const Search& search);
  NewRock instance(Index kind, const RockPose& pose, Bed& bed);
  void charge(Bed& bed, std::vector<NewRock>& rocks);

  const RockLibrary& library_;
  FeedPlan plan_;
  BondStrength strength_;
  std::vector<double> masses_;      ///< of the templates [kg]
  std::vector<double> cumulative_;  ///< share of numbers up to each template, ends with 1
  double largest_radius_;           ///< of any particle [m]
  WallSet walls_;
  std::optional<FeedRegion> charge_, entry_;
  State state_;
};

}  // namespace gyro
