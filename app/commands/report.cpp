// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.hpp"
#include "io/run/summary.hpp"

#include <iostream>

namespace gyro {

int report_command(const std::filesystem::path& run) {
  std::cout << to_text(load_summary(run), run);
  return exit_done;
}

}  // namespace gyro
