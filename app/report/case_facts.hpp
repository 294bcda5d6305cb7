// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/size_distribution.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace gyro::report {

/// What the page needs of the case of a run. A fact that the case does not have is empty.
struct CaseFacts {
  std::optional<double> closed_setting, open_setting;  ///< [m]
  std::optional<SizeLaw> feed;                         ///< sizes of rocks as fed, by equal-volume diameter
  std::optional<double> wear_coefficient;              ///< of output.liners [1/Pa]
  std::map<std::string, double> wall_friction;         ///< of rock on each wall, by its name [-]
};

/// @param yaml  resolved case, of which all numbers are SI
/// @param file  case.yaml of the run: a feed of which the sieves lie in a file is read from there
CaseFacts case_facts(const std::string& yaml, const std::filesystem::path& file);

}  // namespace gyro::report
