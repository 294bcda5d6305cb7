// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command_line.hpp"
#include "app/commands/commands.hpp"
#include "core/base/errors.hpp"

#include <cstdio>
#include <iostream>
#include <new>

namespace {

using namespace gyro;

int guarded(const std::function<int()>& command) {
  try {
    const int code = command();
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout))
      throw OutputError("standard output: cannot be written to the end");
    return code;
  } catch (const BadInput& e) {
    std::cerr << e.what() << "\n";
    return exit_bad_input;
  } catch (const StoppedByGuard& e) {
    std::cerr << e.what() << "\n";
    return exit_stopped;
  } catch (const OutputError& e) {
    std::cerr << e.what() << "\n";
    return exit_output;
  } catch (const NoDevice& e) {
    std::cerr << e.what() << "\n";
    return exit_no_device;
  } catch (const std::bad_alloc&) {
    std::cerr << "out of memory; reduce the particle count (see gyrosim check)\n";
    return exit_no_device;
  } catch (const std::exception& e) {
    std::cerr << "internal error: " << e.what() << "\n";
    return exit_internal;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const CommandLine line = parse_command_line(argc, argv);
  return line.command ? guarded(line.command) : line.exit_code;
}
