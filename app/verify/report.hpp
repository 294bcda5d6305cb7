// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands.hpp"
#include "app/verify/check.hpp"

namespace gyro::verify {

/// Runs the cases that the arguments ask for and prints their checks: a line each and a table of the
/// groups, or one JSON document.
/// @return exit_done, or exit_check_failed when a check failed
/// @throws BadInput for a filter that is no regular expression or that no check fits
int report(std::span<const Case> cases, const VerifyArguments& arguments);

}  // namespace gyro::verify
