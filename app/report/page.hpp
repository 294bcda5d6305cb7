// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gyro::report {

/// A page with our styles and scripts inside, which needs no other file. It is well-formed XML as well.
/// @param content  HTML of the sections
std::string html_page(std::string_view title, std::string_view subtitle, const std::string& content);

/// The report of runs that have ended. @throws BadInput with the path for a missing or damaged run
std::string report_page(const std::vector<std::filesystem::path>& runs);

}  // namespace gyro::report
