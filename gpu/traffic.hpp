// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exec/traffic.hpp"

namespace gyro {

/// Of all executors of the program, which one thread drives.
inline Traffic& traffic() {
  static Traffic counted;
  return counted;
}
inline void count_read(std::size_t bytes) {
  ++traffic().reads;
  traffic().bytes_read += static_cast<std::int64_t>(bytes);
}
inline void count_write(std::size_t bytes) {
  ++traffic().writes;
  traffic().bytes_written += static_cast<std::int64_t>(bytes);
}

}  // namespace gyro
