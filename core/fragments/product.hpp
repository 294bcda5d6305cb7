// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/fragments/concave_outline.hpp"
#include "core/fragments/fragment_record.hpp"
#include "core/fragments/sieve_curve.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace gyro {

/// The account of rock that leaves the chamber. A fragment leaves once, in the first of two ways that an update
/// detects:
///
/// - escaped, over the rim: all of it is below the rim, and the centres of all its particles are outside of the
///   concave's outline (concave_outline.hpp);
/// - discharged, through the opening: all of it is below z = 0, and it has not escaped. Without an outline all rock
/// that falls below z = 0 is discharged.
///
/// Discharged rock is the product. It is counted with its size at that moment, even if it bounces back or breaks
/// further later. Of escaped rock only particles and mass are counted.
class Product {
 public:
  /// Where a particle is.
  using Place = FragmentRecord::Place;
  using enum FragmentRecord::Place;

  /// Everything that a checkpoint keeps.
  struct State {
    std::vector<std::uint8_t> place;  ///< by particle id
    /// By sieve: mass that passes it but not the next finer one; the last entry: mass that passes none [kg].
    std::vector<double> sieve_mass;
    std::int64_t particles = 0, fragments = 0, singles = 0;  ///< discharged
    double mass = 0, singles_mass = 0;                       ///< discharged [kg]
    std::int64_t escaped_particles = 0;
    double escaped_mass = 0;  ///< [kg]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("place", s.place...);
      f("sieve_mass", s.sieve_mass...);
      f("particles", s.particles...);
      f("fragments", s.fragments...);
      f("singles", s.singles...);
      f("mass", s.mass...);
      f("singles_mass", s.singles_mass...);
      f("escaped_particles", s.escaped_particles...);
      f("escaped_mass", s.escaped_mass...);
    }
  };

  /// @param rock_density  of solid rock [kg/m3], for the size of single particles
  /// @param concave       if there is none, no rock escapes
  /// @param sieves        of the analysis, increasing [m]
  explicit Product(double rock_density, std::optional<ConcaveOutline> concave = {},
                   std::vector<double> sieves = sieve_series());
  /// With the state of an earlier account on the same sieves.
  Product(double rock_density, std::optional<ConcaveOutline> concave, std::vector<double> sieves, State state);

  /// Counts the fragments that have left the chamber since the last update.
  /// @param table  of these particles
  /// @returns them, without the time
  std::vector<FragmentRecord> update(const FragmentTable& table, const ParticleSnapshot& particles);

  /// Ids of the particles of all fragments that have left the chamber and lie completely below z = -depth.
  /// @param depth  [m], >= 0
  std::vector<ParticleId> removable(const FragmentTable& table, const ParticleSnapshot& particles, double depth) const;

  bool has_left(ParticleId id) const;
  /// Number of particles of a snapshot that have not left: the hold-up of the chamber.
  std::int64_t inside(const ParticleSnapshot& particles) const;
  /// Sieve analysis of the discharged rock. @param time  of the row [s]
  ProductRow row(double time) const;
  const std::vector<double>& sieves() const { return sieves_; }
  const State& state() const { return state_; }

 private:
  bool is_outside(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles) const;
  void mark(const FragmentTable& table, std::size_t row, const ParticleSnapshot& particles, Place place);
  void count_discharged(const FragmentRecord& fragment);

  double rock_density_;
  std::optional<ConcaveOutline> concave_;
  std::vector<double> sieves_;
  State state_;
};

}  // namespace gyro
