// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/catch.hpp"

#include "core/base/expect.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>

namespace {

/// Signal that ends a process that expects this condition; 0 if it exits normally.
int signal_of_expecting(bool condition) {
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGABRT, SIG_DFL);  // not the test program's handler
    if (std::freopen("/dev/null", "w", stderr) == nullptr) std::_Exit(0);
    GYRO_EXPECT(condition);
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

}  // namespace

TEST_CASE("An expectation that holds changes nothing", "[base]") {
  CHECK(signal_of_expecting(true) == 0);
}

TEST_CASE("A violated expectation stops a debug build and is not evaluated in a release build", "[base]") {
  int evaluated = 0;
  GYRO_EXPECT(++evaluated > 0);
#if defined(NDEBUG)
  CHECK(evaluated == 0);
  CHECK(signal_of_expecting(false) == 0);
#else
  CHECK(evaluated == 1);
  CHECK(signal_of_expecting(false) == SIGABRT);
#endif
}
