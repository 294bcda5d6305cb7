// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/accounts.hpp"
#include "core/scene/new_rock.hpp"
#include "core/scene/snapshot.hpp"

#include <span>
#include <vector>

namespace gyro {

/// What has happened to the rock in the scene since it was fed: the energy that its breaking bonds released, and the
/// size that each rock had. A bond gives half of its energy to each of its two particles, so that the energy of a
/// fragment is the sum over its particles, and all particles together have what the ledger calls bond_breakage.
class RockHistory {
 public:
  /// Everything that a checkpoint keeps: of the particles and rocks that are in the scene.
  struct State {
    std::vector<ParticleId> particle;  ///< ascending
    std::vector<double> energy;        ///< of each [J]
    std::vector<RockId> rock;          ///< ascending
    std::vector<double> size;          ///< of each when it was fed: equal-mass diameter [m]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("particle", s.particle...);
      f("energy", s.energy...);
      f("rock", s.rock...);
      f("size", s.size...);
    }
  };

  /// @param rock_density  of solid rock [kg/m3]
  explicit RockHistory(double rock_density) : RockHistory(rock_density, State{}) {}
  RockHistory(double rock_density, State state) : rock_density_(rock_density), state_(std::move(state)) {}

  void feed(std::span<const NewRock> rocks);
  /// Adds broken bonds, of particles in the scene, in their order.
  void add(std::span<const Breakage> broken);
  /// Forgets particles, and the rocks of which none is left.
  /// @param gone       ids, ascending
  /// @param particles  before they went
  void remove(std::span<const ParticleId> gone, const ParticleSnapshot& particles);

  /// Energy of each particle of a snapshot [J]; 0 of one that was never fed.
  std::vector<double> energies(const ParticleSnapshot& particles) const;
  /// Size of a rock when it was fed [m]; 0 of one that was never fed.
  double size_of(RockId rock) const;
  const State& state() const { return state_; }

 private:
  void give(ParticleId id, double energy);

  double rock_density_;
  State state_;
};

}  // namespace gyro
