// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/run/index_file.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// A ParaView index of frames (.pvd).
class FrameIndex {
 public:
  /// @param file  for the index; it is created by the first call of add() or write()
  explicit FrameIndex(std::filesystem::path file);

  /// Adds a frame. @param time  [s]  @param parts  its files, relative to the index
  /// @throws OutputError; the index is then unchanged
  void add(double time, std::span<const std::string> parts);

  /// Replaces the index. @param times  of the frames [s]  @param parts  files of each frame
  void write(std::span<const double> times, std::span<const std::vector<std::string>> parts);

 private:
  IndexFile file_;
};

}  // namespace gyro
