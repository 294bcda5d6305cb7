// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/product.hpp"

#include <cstdint>
#include <vector>

namespace gyro {

/// Sieve analysis of what has not been discharged. Sizes of fragments are remembered from one analysis to the next:
/// bonds never heal, so a fragment with the same first particle and as many particles as before is the same one.
class HoldUp {
 public:
  /// Everything that a checkpoint must keep. The columns have one row a fragment of several particles, by first
  /// particle.
  struct State {
    std::vector<ParticleId> first;
    std::vector<Index> particles;
    std::vector<double> size;  ///< [m]
    SieveTally tally;          ///< of the last analysis

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("first", s.first...);
      f("particles", s.particles...);
      f("size", s.size...);
      f("tally", s.tally...);
    }
  };

  /// @param rock_density  of solid rock [kg/m3]
  explicit HoldUp(double rock_density, State state = {});

  /// Analyses what is there now.
  /// @param table    of these particles
  /// @param product  after its update with them
  void update(const FragmentTable& table, const ParticleSnapshot& particles, const Product& product);
  /// The last analysis.
  ProductRow row(double time) const { return state_.tally.row(time); }
  const State& state() const { return state_; }

 private:
  double rock_density_;
  State state_;
};

}  // namespace gyro
