// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/assembly/expected_bytes.hpp"
#include "app/assembly/free_memory.hpp"
#include "app/simulation/setup.hpp"
#include "app/simulation/time_step.hpp"
#include "io/case/case.hpp"

#include <optional>
#include <string>
#include <vector>

// Amount of rock in a case, computed from masses and the library before any rock is placed.

namespace gyro {

/// Counts as double, because a wrong unit can give numbers that exceed the range of integers.
struct ExpectedCounts {
  double rocks = 0, particles = 0, bonds = 0;              ///< at the start, a batch included
  double fed_rocks = 0, fed_particles = 0, fed_bonds = 0;  ///< by the feed's rate over the run
  double steps = 0;
  double window_bytes = 0;  ///< of the poses of the walls in the steps of a coupling interval
  double bytes_at_start = 0;
  double bytes = 0;  ///< of the start and of what the rate feeds, if all of it finds room and nothing is discharged
};

/// @param duration  of the run [s]
ExpectedCounts expected_counts(const Setup& setup, const StepChoice& step, Precision precision, double duration);

/// Refuses more steps than can be counted.
/// @param until  end of the run in place of time.duration [s]
/// @throws BadKey for the time in the case that is to blame, BadInput for `until`
void check_steps(const ExpectedCounts& counts, const Case& input, const StepChoice& step, std::optional<double> until);

/// Refuses cases with more particles than ids, and starts that need more memory than is free. What the rate feeds over
/// the run is only noted: nobody knows how much of it finds room, and how much is in the scene at the same time.
/// @return notes on large but possible cases
/// @throws BadKey for `feed`, `particles` or `coupling.interval`, with the counts
std::vector<std::string> check_counts(const ExpectedCounts& counts, const Setup& setup,
                                      const FreeMemory& memory = free_memory());

}  // namespace gyro
