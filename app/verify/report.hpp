// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/commands.hpp"
#include "app/verify/check.hpp"
#include "app/verify/lines.hpp"

namespace gyro::verify {

/// Runs the cases that have a line that the arguments ask for and prints these: a line each and a table of
/// the groups, or one JSON document.
/// @param lines  of all cases
/// @return exit_done, or exit_check_failed when a check failed
/// @throws BadInput for a filter that is no regular expression or that no check fits,
/// std::logic_error when a case prints other lines than are listed
int report(std::span<const Case> cases, const Lines& lines, const VerifyArguments& arguments);

}  // namespace gyro::verify
