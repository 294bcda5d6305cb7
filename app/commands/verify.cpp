// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "app/verify/report.hpp"

namespace gyro {

int verify_command(const VerifyArguments& arguments) {
  return verify::report(verify::all_cases(), verify::all_lines(), arguments);
}

}  // namespace gyro
