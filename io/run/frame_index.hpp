// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// A ParaView index of frames (.pvd), to which frames are added at its end, so that a frame costs the same whatever
/// their number. The file is whole after each call; a reader that comes in between sees a file that ends early.
class FrameIndex {
 public:
  /// @param file  for the index, which is made by the first add()
  explicit FrameIndex(std::filesystem::path file) : file_(std::move(file)) {}

  /// Adds a frame. @param parts  its files, relative to the index
  /// @throws OutputError; then the index is as before
  void add(double time, std::span<const std::string> parts);

  /// Replaces the index. @param parts  of each frame
  void write(std::span<const double> times, std::span<const std::vector<std::string>> parts);

 private:
  std::filesystem::path file_;
  std::size_t end_ = 0;  ///< where the next frame begins, 0: no file yet [bytes]
};

}  // namespace gyro
