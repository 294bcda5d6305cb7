// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/product.hpp"

#include <cstdint>
#include <vector>

namespace gyro {

/// Sieve analysis of the rock in the chamber. Sizes of fragments are kept from one analysis to the next. Bonds never
/// heal, so a fragment with the same first particle and the same number of particles is unchanged.
class HoldUp {
 public:
  /// Everything that a checkpoint keeps. The columns have one row for each fragment of several particles, sorted by
  /// first particle.
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
  /// @param sieves        of the analysis, increasing [m]
  explicit HoldUp(double rock_density, std::vector<double> sieves = sieve_series());
  /// With the state of an earlier analysis on the same sieves.
  HoldUp(double rock_density, std::vector<double> sieves, State state);

  /// Analyses the present hold-up.
  /// @param table    of these particles
  /// @param product  after its update with them
  void update(const FragmentTable& table, const ParticleSnapshot& particles, const Product& product);
  /// The last analysis.
  ProductRow row(double time) const { return state_.tally.row(sieves_, time); }
  /// Size of a fragment of several particles in the last analysis [m]. @param first  its particle of the lowest id
  double size_of(ParticleId first) const;
  const State& state() const { return state_; }

 private:
  double rock_density_;
  std::vector<double> sieves_;
  State state_;
};

}  // namespace gyro
