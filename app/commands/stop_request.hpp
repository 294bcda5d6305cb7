// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// Why a run should end at the end of its window.
enum class StopRequest { keep_going, signal };

/// Catches SIGTERM, SIGINT and SIGUSR1: the first asks the run to end at its next window, a second
/// SIGINT ends the program at once with exit code 130.
void catch_stop_signals();

/// What has been asked for so far.
StopRequest stop_request();

}  // namespace gyro
