// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gyro::verify {

/// For each verification, by its name group/case, the names of its checks, group/case/quantity.
using CheckNames = std::map<std::string, std::vector<std::string>>;

/// The names of all checks, from names.txt. The names of a verification's checks are known only after it has run. With
/// this list a filter can select verifications, or report that none matches, before anything runs.
CheckNames check_names();

}  // namespace gyro::verify
