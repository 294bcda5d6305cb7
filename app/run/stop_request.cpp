// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/stop_request.hpp"

#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <initializer_list>
#include <string_view>

namespace gyro {
namespace {

volatile std::sig_atomic_t signals_seen = 0;
volatile std::sig_atomic_t exit_code_while_loading = 0;  ///< 0: the loop runs and checks signals_seen

void say(std::string_view text) {
  const int reason = errno;  // of the call that the signal interrupts
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  errno = reason;
}

extern "C" void on_signal(int signal) {
  if (exit_code_while_loading != 0) {
    say("\nstopped while the case was being loaded\n");
    _exit(exit_code_while_loading);
  }
  if (signal == SIGINT && signals_seen > 0) _exit(130);
  if (signals_seen == 0)
    say(signal == SIGINT
            ? "\nfinishing this window, or giving it up if it takes more than 5 s, and writing a checkpoint; press "
              "Ctrl-C again to stop at once\n"
            : "\nfinishing this window, or giving it up if it takes more than 5 s, and writing a checkpoint\n");
  signals_seen = signals_seen + 1;
}

}  // namespace

void catch_stop_signals(int exit_code) {
  exit_code_while_loading = exit_code;
  struct sigaction action = {};
  action.sa_handler = on_signal;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGUSR1, SIGXCPU}) {
    struct sigaction before = {};
    sigaction(signal, nullptr, &before);
    // Signals that are already ignored remain ignored: under `nohup`, or Ctrl-C for a background job of a shell.
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  // With these ignored, a failing write returns an error, which is reported after everything else is written.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

void stop_after_window() {
  exit_code_while_loading = 0;
}

bool stop_requested() {
  return signals_seen > 0;
}

}  // namespace gyro
