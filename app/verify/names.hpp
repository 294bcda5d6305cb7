// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gyro::verify {

/// Names of checks, group/case/quantity, by the name of their verification, group/case.
using CheckNames = std::map<std::string, std::vector<std::string>>;

/// The names of all checks, from names.txt. Only a run of a verification tells the names of its checks; with this list
/// a filter selects verifications, or finds that none fits, before anything runs.
CheckNames check_names();

}  // namespace gyro::verify
