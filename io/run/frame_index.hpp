// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// A ParaView index of frames (.pvd). Frames are added at its end, so that the cost of a frame does not depend on their
/// number. The file is complete after each call; during a call a reader may see a file that ends early.
class FrameIndex {
 public:
  /// @param file  for the index; it is created by the first call of add() or write()
  explicit FrameIndex(std::filesystem::path file) : file_(std::move(file)) {}

  /// Adds a frame. @param time  [s]  @param parts  its files, relative to the index
  /// @throws OutputError; the index is then unchanged
  void add(double time, std::span<const std::string> parts);

  /// Replaces the index. @param times  of the frames [s]  @param parts  files of each frame
  void write(std::span<const double> times, std::span<const std::vector<std::string>> parts);

 private:
  std::filesystem::path file_;
  std::size_t end_ = 0;  ///< place of the next frame in the file; 0: no file has been written yet [bytes]
};

}  // namespace gyro
