// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/fragment_table.hpp"
#include "core/fragments/sieve_curve.hpp"

#include <cstdint>
#include <vector>

namespace gyro {

/// The product account. A fragment is discharged when all of it is below z = 0; it is then
/// counted once, with its size at that moment, even if it bounces back or breaks further.
class Product {
 public:
  /// Everything that a checkpoint keeps.
  struct State {
    std::vector<std::uint8_t> discharged;  ///< by particle id: 1 when counted
    /// By sieve: mass that passes it but not the next finer one; last: mass that passes none [kg].
    std::vector<double> sieve_mass;
    std::int64_t particles = 0, fragments = 0, singles = 0;
    double mass = 0, singles_mass = 0;

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("discharged", s.discharged...);
      f("sieve_mass", s.sieve_mass...);
      f("particles", s.particles...);
      f("fragments", s.fragments...);
      f("singles", s.singles...);
      f("mass", s.mass...);
      f("singles_mass", s.singles_mass...);
    }
  };

  /// @param rock_density  of solid rock [kg/m3], for the size of single particles
  explicit Product(double rock_density);
  Product(double rock_density, State state);

  /// Counts the fragments that are newly below the discharge plane.
  /// @param table  of these particles
  void update(const FragmentTable& table, const ParticleSnapshot& particles);

  /// Ids of the particles of all fragments that have been counted and lie completely below z = -depth.
  /// @param depth  [m], >= 0
  std::vector<ParticleId> removable(const FragmentTable& table, const ParticleSnapshot& particles, double depth) const;

  bool is_discharged(ParticleId id) const;
  /// Number of particles of a snapshot that have not been discharged: the hold-up of the chamber.
  std::int64_t inside(const ParticleSnapshot& particles) const;
  ProductRow row(double time) const;
  const State& state() const { return state_; }

 private:
  void count(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles);

  double rock_density_;
  State state_;
};

}  // namespace gyro
