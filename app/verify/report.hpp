// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/names.hpp"
#include "app/verify/verification.hpp"

#include <span>

namespace gyro::verify {

/// What to run and how to print it.
struct ReportOptions {
  std::string filter;    ///< regular expression, searched in the names of checks; empty: all
  bool nightly = false;  ///< the long verifications as well
  bool json = false;     ///< one JSON document in place of lines and a table of the groups
};

/// Runs the verifications that have a check with a name that the filter fits, and prints these checks.
/// @param names  of the checks of all verifications
/// @return whether all printed checks passed
/// @throws BadInput for a filter that is not a regular expression or that fits no check; std::logic_error at the end if
/// the checks that ran have other names than `names`
bool report(std::span<const Verification> verifications, const CheckNames& names, const ReportOptions& options);

}  // namespace gyro::verify
