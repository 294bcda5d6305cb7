// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace gyro {

/// A text file that lists frames between a head and a tail. Frames are added at its end, so that the cost of a frame
/// does not depend on their number. The file is complete after each call; during a call a reader may see a file that
/// ends early.
class IndexFile {
 public:
  /// @param path  of the file; it is created by the first call of add() or write()
  /// @param head, tail  of the file
  IndexFile(std::filesystem::path path, std::string head, std::string tail)
      : path_(std::move(path)), head_(std::move(head)), tail_(std::move(tail)) {}

  /// Adds a frame. @throws OutputError; the file is then unchanged
  void add(std::string_view frame);
  /// Replaces the file. @param frames  text of each. @throws OutputError
  void write(std::span<const std::string> frames);

 private:
  std::filesystem::path path_;
  std::string head_, tail_;
  std::size_t end_ = 0;  ///< place of the next frame in the file; 0: no file has been written yet [bytes]
};

}  // namespace gyro
