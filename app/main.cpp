// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/command_line.hpp"
#include "app/commands/commands.hpp"
#include "core/base/errors.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace {

using namespace gyro;

bool is_lack_of_threads(const std::exception& failure) {
  const auto* of_system = dynamic_cast<const std::system_error*>(&failure);
  return of_system != nullptr && of_system->code() == std::errc::resource_unavailable_try_again;
}

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
  } catch (const std::filesystem::filesystem_error& e) {
    std::cerr << e.what() << "\n";
    return exit_bad_input;
  } catch (const std::exception& e) {
    if (is_lack_of_threads(e)) {
      std::cerr << "the system starts no more threads for this user; give fewer with --threads\n";
      return exit_no_device;
    }
    std::cerr << "internal error: " << e.what() << "\n";
    return exit_internal;
  }
}

/// A caller may have closed standard input, output or error: then the next file that is opened would get its number,
/// and messages would be written into that file.
void open_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(stream, F_GETFD) < 0 && ::open("/dev/null", O_RDWR) != stream) std::abort();
}

/// Columns that are freed go back to the system at once. Otherwise the C library would keep them, and not find room
/// in them for columns that have grown.
void return_freed_columns() {
#ifdef __GLIBC__
  constexpr int smallest = 1 << 20;  // [bytes]
  ::mallopt(M_MMAP_THRESHOLD, smallest);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  open_standard_streams();
  return_freed_columns();
  const CommandLine line = parse_command_line(argc, argv);
  return line.command ? guarded(line.command) : line.exit_code;
}
