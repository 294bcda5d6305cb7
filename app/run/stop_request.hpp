// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// Catches SIGTERM, SIGINT and SIGUSR1: the first asks the run to end after its window, a second SIGINT ends the
/// program at once with exit code 130.
void catch_stop_signals();

/// Whether a signal has asked the run to end.
bool stop_requested();

}  // namespace gyro
