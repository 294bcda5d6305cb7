// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/stop_request.hpp"

#include <unistd.h>
#include <csignal>
#include <initializer_list>

namespace gyro {
namespace {

volatile std::sig_atomic_t signals_seen = 0;

extern "C" void on_signal(int signal) {
  if (signal == SIGINT && signals_seen > 0) _exit(130);
  signals_seen = signals_seen + 1;
}

}  // namespace

void catch_stop_signals() {
  struct sigaction action = {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  for (const int signal : {SIGTERM, SIGINT, SIGUSR1}) sigaction(signal, &action, nullptr);
}

bool stop_requested() {
  return signals_seen > 0;
}

}  // namespace gyro
