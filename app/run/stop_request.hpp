// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// Catches SIGTERM, SIGINT, SIGHUP, SIGUSR1 and SIGXCPU, except those that the caller of the program ignores. Until
/// stop_after_window() is called, the first of them ends the program. Writing to a closed pipe or beyond the size limit
/// of files returns an error instead of ending the program.
/// @param exit_code  of the program if a signal arrives before stop_after_window(); not 0
void catch_stop_signals(int exit_code);

/// From here on the first signal asks the run to end after its window; a second SIGINT ends the program at once with
/// exit code 130.
void stop_after_window();

/// Whether a signal has asked the run to end.
bool stop_requested();

}  // namespace gyro
