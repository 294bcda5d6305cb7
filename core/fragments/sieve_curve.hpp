// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gyro {

/// Sieves from 1 mm to 1 m, each sqrt(2) times the one before: 125 mm x 2^(k/2), k = -14 ... 6 [m].
const std::vector<double>& sieve_series();

/// The finest sieve of the series that lets this size through; the number of sieves when none does.
std::size_t sieve_of(double size);

/// Size that a share of the mass passes: passing is linear in log(size) between two sieves.
/// None when the share lies below the finest or above the coarsest sieve.
/// @param passing  [sieve_series()], not decreasing
std::optional<double> passing_size(const std::vector<double>& passing, double share);

/// The way back: share of the mass that passes a mesh of this size, linear in log(size) between two sieves; that of
/// the finest sieve below it.
double passing_at(const std::vector<double>& passing, double size);

/// A sieve analysis: of all that was discharged by a time, or of what the chamber holds.
struct ProductRow {
  double time = 0;                 ///< [s]
  double mass = 0;                 ///< [kg]
  std::int64_t particles = 0;      ///< exact
  std::int64_t fragments = 0;      ///< as they were when they passed the discharge plane
  double singles_share = 0;        ///< mass of single particles / mass [-]; 0 without mass
  std::vector<double> passing;     ///< mass share finer than each sieve of the series [-]; zeros without mass
  std::optional<double> p80, p50;  ///< sizes that 80 % and 50 % of the mass pass [m]; none without mass
};

/// Mass by sieve.
struct SieveTally {
  std::vector<double> sieve_mass = std::vector<double>(sieve_series().size() + 1, 0.0);
  ///< by sieve: mass finer than it and not than the next finer; last: coarser than all [kg]
  std::int64_t particles = 0, fragments = 0;
  double mass = 0, singles_mass = 0;  ///< [kg]

  template <class F, class... T>
  static constexpr void for_each_field(F&& f, T&... t) {
    f("sieve_mass", t.sieve_mass...);
    f("particles", t.particles...);
    f("fragments", t.fragments...);
    f("mass", t.mass...);
    f("singles_mass", t.singles_mass...);
  }

  /// A fragment of this sieve size [m].
  void add(double size, double fragment_mass, std::int64_t fragment_particles);
  ProductRow row(double time) const;
};

}  // namespace gyro
