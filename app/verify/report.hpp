// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/names.hpp"
#include "app/verify/verification.hpp"

#include <span>

namespace gyro::verify {

/// What to run and how to print it.
struct ReportOptions {
  std::string filter;    ///< regular expression, searched in the names of checks; empty: all
  bool nightly = false;  ///< also run the long verifications
  bool json = false;     ///< print one JSON document in place of lines and a table of the groups
};

/// Runs the verifications that have a check whose name matches the filter, and prints the matching checks.
/// @param names  of the checks of all verifications
/// @return whether all printed checks passed
/// @throws BadInput for a filter that is not a regular expression or that matches no check; std::logic_error at the end
/// if the names of the checks that ran differ from `names`
bool report(std::span<const Verification> verifications, const CheckNames& names, const ReportOptions& options);

}  // namespace gyro::verify
