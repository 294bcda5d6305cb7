// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/process_memory.hpp"

#include <fstream>
#include <string>

namespace gyro::bench {
namespace {

/// A line of /proc/self/status, which counts in kB.
std::int64_t status(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string word; file >> word;) {
    std::int64_t kilobytes = 0;
    if (word == name && file >> kilobytes) return 1024 * kilobytes;
  }
  return 0;
}

}  // namespace

std::int64_t resident_bytes() {
  return status("VmRSS:");
}
std::int64_t peak_resident_bytes() {
  return status("VmHWM:");
}

}  // namespace gyro::bench
