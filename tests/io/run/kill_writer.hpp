// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/catch.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace gyro {

/// Starts `write` in another process and waits until it has written a byte to a pipe, and then for a time. Then calls
/// `look`, and kills the process.
template <class Write, class Look>
void kill_writer_after(useconds_t microseconds, const Write& write, const Look& look) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) write(ends[1]);
  char begun = 0;
  REQUIRE(::read(ends[0], &begun, 1) == 1);
  ::usleep(microseconds);
  look();
  ::kill(child, SIGKILL);
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ends[0]);
  ::close(ends[1]);
  REQUIRE(WIFSIGNALED(status));
}

}  // namespace gyro
