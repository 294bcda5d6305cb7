// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/io/run/scratch.hpp"

#include <fstream>

namespace gyro {

/// Writes a file into a directory. @return its path
inline std::string written(const ScratchDirectory& directory, const std::string& name, const std::string& bytes) {
  std::ofstream(directory.path() / name, std::ios::binary) << bytes;
  return (directory.path() / name).string();
}

}  // namespace gyro
