// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gyro {

/// Sieves from 1 mm to 1 m, each sqrt(2) times the one before: 125 mm x 2^(k/2), k = -14 ... 6 [m].
const std::vector<double>& sieve_series();

/// Index of the finest sieve that this size [m] passes; the number of sieves if it passes none.
/// @param sieves  increasing [m]
std::size_t sieve_of(const std::vector<double>& sieves, double size);

/// Size [m] that a share of the mass passes: passing is linear in log(size) between two sieves.
/// None if the share lies below the finest or above the coarsest sieve.
/// @param passing  of each sieve, not decreasing
std::optional<double> passing_size(const std::vector<double>& sieves, const std::vector<double>& passing, double share);

/// The inverse: share of the mass that passes an opening of this size [m], linear in log(size) between two sieves.
/// None below the finest and above the coarsest sieve.
std::optional<double> passing_at(const std::vector<double>& sieves, const std::vector<double>& passing, double size);

/// A sieve analysis: of all rock discharged up to a time, or of the rock in the chamber.
struct ProductRow {
  double time = 0;  ///< [s]
  double mass = 0;  ///< [kg]
  std::int64_t particles = 0;
  std::int64_t fragments = 0;      ///< as they were when they passed the discharge plane
  double singles_share = 0;        ///< mass of single particles / mass [-]; 0 without mass
  std::vector<double> sieves;      ///< openings [m]
  std::vector<double> passing;     ///< mass share finer than each sieve [-]; zeros without mass
  std::optional<double> p80, p50;  ///< sizes that 80 % and 50 % of the mass pass [m]; none without mass
};

/// Mass by sieve.
struct SieveTally {
  /// By sieve: mass that passes it but not the next finer one; the last entry: mass that passes none [kg]. Empty
  /// without mass.
  std::vector<double> sieve_mass;
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

  /// Adds a fragment of this sieve size [m] and mass [kg]. @param sieves  the same in all calls
  void add(const std::vector<double>& sieves, double size, double fragment_mass, std::int64_t fragment_particles);
  ProductRow row(const std::vector<double>& sieves, double time) const;
};

}  // namespace gyro
