// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// Exit codes of the program (README.md).
enum ExitCode : int {
  exit_done = 0,
  exit_internal = 1,
  exit_bad_input = 2,
  exit_check_failed = 3,
  exit_stopped = 4,
  exit_output = 5,
  exit_no_device = 6,
  exit_interrupted = 75,
};

}  // namespace gyro
