// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>

namespace gyro {

/// A file cannot be read. The message is the path and the problem.
struct UnreadableFile : BadInput {
  UnreadableFile(const std::filesystem::path& path, const std::string& problem_);
  std::string problem;  ///< what is wrong and what to do, without the path
};

/// All bytes of a file. A read error in the middle of the file is an error, and is not taken for the end of the file. A
/// pipe is read while somebody writes into it at least every 10 s, up to 256 MB; its content can be read only once.
/// @param largest  largest allowed size [bytes]
/// @throws UnreadableFile if it is missing, a directory, a device or too large, or if a read fails
std::string read_file(const std::filesystem::path& path, std::size_t largest = std::numeric_limits<std::size_t>::max());

}  // namespace gyro
