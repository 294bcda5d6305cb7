// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/verify/report.hpp"

namespace gyro {

int verify_command(const VerifyArguments& arguments) {
  const bool passed = verify::report(verify::all_verifications(), verify::check_names(),
                                     {arguments.filter, arguments.nightly, arguments.json});
  return passed ? exit_done : exit_check_failed;
}

}  // namespace gyro
