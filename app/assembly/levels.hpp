// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/setup.hpp"
#include "io/case/case.hpp"

#include <string>

namespace gyro {

/// Sets the levels of detail of the case: load tables of the library's rocks and of those of the start.
/// @param threads  that compute them; 0: all cores
/// @return a note on them for the log; empty without levels
std::string set_levels(Setup& setup, const Case& input, int threads);

}  // namespace gyro
