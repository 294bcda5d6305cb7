// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gyro::verify {

/// Names of checks, group/case/quantity, by the name of their case: a filter need not run a case to know them.
using Lines = std::map<std::string, std::vector<std::string>>;

/// The checks of all cases, from lines.txt.
Lines all_lines();

}  // namespace gyro::verify
