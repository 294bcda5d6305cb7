// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/output/gyrations.hpp"
#include "core/fragments/sieve_curve.hpp"
#include "io/run/summary.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Figures of a crusher in steady operation.
///
/// Standard errors come from blocks of whole gyrations by the jackknife: with B blocks and a figure f_k of all but
/// block k, error^2 = (B - 1)/B sum (f_k - mean f)^2 (Efron & Stein, Ann. Statist. 9 (1981) 586). For a mean of equal
/// blocks that is the variance of the blocks / B; it holds for ratios and sieve sizes as well. A block is at least two
/// gyrations and a tenth of the steady part, so that neighbouring blocks depend little on each other; the error itself
/// is good to about 1 / sqrt(2 B - 2), a third with five blocks. None if a figure is not defined without some block.
struct SteadyState {
  double from = 0;                             ///< [s]
  std::size_t gyrations = 0, blocks = 0;       ///< whole gyrations since then, and blocks of them
  Estimate power;                              ///< crushing, mean [W]
  Estimate motor_power;                        ///< mean [W]
  Estimate throughput;                         ///< [kg/s]
  std::optional<Estimate> specific_energy;     ///< crushing energy / mass discharged [J/kg]; none without discharge
  std::optional<Estimate> p80, p50;            ///< sizes that these shares of the mass discharged pass [m]
  std::vector<std::optional<Estimate>> below;  ///< share of the mass discharged that passes each of the sizes asked for
  std::optional<double> residence_time;        ///< mean hold-up / throughput (Little's law) [s]; none without discharge
};

/// Limits below which a drift is neglected.
struct SteadyLimits {
  std::size_t min_gyrations = 10;
  double holdup_drift = 0.05;  ///< change of its fitted line over the evaluated time / mean [-]
  double speed_drift = 0.02;   ///< likewise of the duration of a gyration [-]
  double power_change = 0.05;  ///< between the two halves of that time / mean [-]
};

/// The earliest gyration from which on, to the end of the run, hold-up, speed and power have no drift: the lines fitted
/// to hold-up and to the duration of a gyration change by less than holdup_drift and speed_drift of their means, and
/// the mean powers of both halves differ by less than power_change or by less than two standard errors. A chamber that
/// fills more slowly than the limit also counts as steady: check the hold-up.
/// @return nothing if the run never becomes steady, or if fewer than min_gyrations follow
/// @param sizes   openings [m] of SteadyState::below
/// @param sieves  of GyrationRecord::sieve_mass [m]
std::optional<SteadyState> steady_state(const GyrationRecord& record, std::span<const double> sizes = {},
                                        const SteadyLimits& limits = {},
                                        const std::vector<double>& sieves = sieve_series());

/// Why a run is not steady, for a record that has no steady state: "the chamber is still filling".
std::string unsteady_reason(const GyrationRecord& record, const SteadyLimits& limits = {});

}  // namespace gyro
