// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/member.hpp"

#include <map>
#include <string>
#include <vector>

namespace gyro::bench {

/// The runs of one setting, by seed 1, 2, ...
struct Ensemble {
  std::vector<MemberResult> members;

  /// Values of a metric by seed; NaN if a run was stopped or had nothing to measure.
  std::vector<double> values(const std::string& metric) const;
  double cpu_per_simulated_second() const;  ///< mean over members
  int stopped() const;                      ///< members that the guard stopped
  std::string first_reason() const;         ///< of the first stopped member; empty if there is none
};

/// Runs seeds 1 to `seeds`, each on one thread, `threads` of them at the same time.
/// @throws BadInput for a bad case or setting
Ensemble run_ensemble(const Member& first, int seeds, int threads);

}  // namespace gyro::bench
