// SPDX-License-Identifier: GPL-3.0-or-later
// Commands whose code is half of the program and no part of a first run. `gyrosim` hands them, with its own command
// line, to `gyrosim-complete`, which has them inside; an installed gyrosim is the complete one.
#include "app/commands/commands.hpp"
#include "app/commands/program_files.hpp"
#include "core/base/errors.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace gyro {
namespace {

std::vector<std::string> own_command_line() {
  std::ifstream file("/proc/self/cmdline");
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) words.push_back(word);
  return words;
}

/// Replaces this process; comes back only with an exception.
int run_complete_program() {
  const std::string program = program_part("gyrosim-complete", "gyrosim-complete");
  std::vector<std::string> words = own_command_line();
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(program.c_str(), arguments.data());
  throw OutputError(program + ": cannot be run: " + std::strerror(errno));
}

}  // namespace

int verify_command(const VerifyArguments&) {
  return run_complete_program();
}

int bench_accuracy_command(const BenchAccuracyArguments&) {
  return run_complete_program();
}

int bench_speed_command(const BenchSpeedArguments&) {
  return run_complete_program();
}

}  // namespace gyro
