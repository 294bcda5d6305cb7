// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/steady_state.hpp"

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace gyro {

/// How well the figures of a run are known so far: relative standard errors, infinite where a figure is not known.
struct SteadyProgress {
  static constexpr double unknown = std::numeric_limits<double>::infinity();

  double from = 0;                               ///< the run is steady from here on [s]
  std::size_t gyrations = 0;                     ///< since then; 0 while the run is not steady
  double throughput = unknown, power = unknown;  ///< power: crushing [-]
  double p80 = unknown;                          ///< [-]
  std::string not_steady = {};                   ///< why the run is not steady; empty if it is

  double worst() const;
};

/// Gyrations of the steady part from which on its errors are believed: ten blocks of two. An error from B blocks is
/// itself good to 1/sqrt(2 B - 2), a quarter with ten. With five a run would often stop because its error happens to be
/// small.
inline constexpr std::size_t gyrations_of_errors = 20;

/// @param record  all gyrations of the run so far
/// @param sieves  of record.sieve_mass [m]
SteadyProgress steady_progress(const GyrationRecord& record, const std::vector<double>& sieves);

/// Whether throughput, crushing power and P80 are known to this relative standard error [-].
bool is_known(const SteadyProgress& progress, double error);

/// "throughput 3.1 %, crushing power 1.2 %, P80 2.2 %"; or why the run is not steady.
std::string to_text(const SteadyProgress& progress);

}  // namespace gyro
