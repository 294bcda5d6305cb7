// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// Lets threads that wait for others sleep after some 30 us. GCC's OpenMP library spins for milliseconds,
/// which costs a factor of ten and more as soon as anything else runs on the machine. It reads its
/// setting when the program is loaded, so that this starts the program again, once. Does nothing if
/// OMP_WAIT_POLICY or GOMP_SPINCOUNT is set.
void shorten_thread_waits(char** argv);

}  // namespace gyro
