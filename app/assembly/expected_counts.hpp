// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/setup.hpp"
#include "app/simulation/time_step.hpp"

#include <string>
#include <vector>

// How much rock a case has, known from masses and the library, before any rock is placed.

namespace gyro {

/// Counts as double: a wrong unit makes numbers that no integer holds.
struct ExpectedCounts {
  double rocks = 0, particles = 0, bonds = 0;  ///< at the start, a batch included
  double fed_rocks = 0, fed_particles = 0;     ///< by the feed's rate over the run
  double steps = 0;
  double bytes = 0;  ///< of the start and of what the rate feeds, if nothing is discharged
};

/// Bytes of particles and bonds with their lists and histories; quickstart: 1.78 MB for 2041 and 5037.
double expected_bytes(double particles, double bonds);

/// @param duration  of the run [s]
ExpectedCounts expected_counts(const Setup& setup, const StepChoice& step, double duration);

/// Bytes that the machine can still give; infinite where that is not known.
double available_memory();

/// Refuses what cannot be run: more particles than ids, more memory than there is, more steps than can be counted.
/// @return notes on what is large but possible
/// @throws BadKey for `feed`, `particles` or `time.duration`, with the counts
std::vector<std::string> check_counts(const ExpectedCounts& counts, const Setup& setup);

}  // namespace gyro
