// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/setup.hpp"
#include "io/case/case.hpp"

#include <string>
#include <vector>

// Signs that a wall is not where its author thinks: too far from the rock, or too small for it.

namespace gyro {

/// Notes on walls that lie so far from the rock that nothing can touch them. Rock is where the start state, placed
/// rocks and the wall of feed.above are; from there it comes as far as all that is, and downwards as far as it falls.
/// @param end  of the run [s]
std::vector<std::string> reach_notes(const Case& input, const Setup& setup, double end);

/// Notes on walls smaller than the smallest particle.
std::vector<std::string> tiny_wall_notes(const Case& input, const Setup& setup);

}  // namespace gyro
