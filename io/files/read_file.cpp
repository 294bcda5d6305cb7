// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/read_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <system_error>

namespace gyro {
namespace {

constexpr std::size_t largest_of_pipe = std::size_t{256} << 20;
constexpr int longest_silence = 10'000;  // of a pipe [ms]

/// A file that is open for reading.
class OpenFile {
 public:
  /// @param pipe  a pipe is opened at once, also if nobody writes into it
  OpenFile(const std::filesystem::path& path, bool pipe) : path_(path), pipe_(pipe) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | (pipe ? O_NONBLOCK : 0));
    if (descriptor_ < 0) fail("check its permissions");
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// Reads at most `size` bytes. @return number of bytes read; 0 at the end
  std::size_t read(char* bytes, std::size_t size) const {
    for (;;) {
      if (pipe_) wait_for_bytes();
      const ssize_t got = ::read(descriptor_, bytes, size);
      if (got >= 0) return static_cast<std::size_t>(got);
      if (errno != EINTR && errno != EAGAIN) fail("check the disk, or copy the file again");
    }
  }

 private:
  void wait_for_bytes() const {
    pollfd waiting{descriptor_, POLLIN, 0};
    if (::poll(&waiting, 1, longest_silence) == 0)
      throw UnreadableFile(path_, "is a pipe into which nobody has written for 10 s; give a file");
  }
  [[noreturn]] void fail(const char* advice) const {
    throw UnreadableFile(path_, "cannot be read: " + std::generic_category().message(errno) + "; " + advice);
  }

  const std::filesystem::path& path_;
  bool pipe_;
  int descriptor_;
};

}  // namespace

UnreadableFile::UnreadableFile(const std::filesystem::path& path, const std::string& problem_)
    : BadInput(path.string() + ": " + problem_), problem(problem_) {}

std::string read_file(const std::filesystem::path& path, std::size_t largest) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    throw UnreadableFile(path, "no such file; check the path");
  if (std::filesystem::is_directory(status)) throw UnreadableFile(path, "is a directory; give a file");
  if (std::filesystem::is_character_file(status) || std::filesystem::is_block_file(status))
    throw UnreadableFile(path, "is a device; give a file");
  if (std::filesystem::is_socket(status)) throw UnreadableFile(path, "is a socket; give a file");
  const bool pipe = std::filesystem::is_fifo(status);
  if (pipe) largest = std::min(largest, largest_of_pipe);
  const OpenFile file(path, pipe);
  constexpr std::size_t chunk = std::size_t{1} << 20;
  std::string bytes;
  for (std::size_t size = 0;;) {
    bytes.resize(size + chunk);
    const std::size_t got = file.read(bytes.data() + size, chunk);
    size += got;
    if (size > largest)
      throw UnreadableFile(path, "is larger than " + std::to_string(largest >> 20) + " MB; give another file");
    if (got > 0) continue;
    bytes.resize(size);
    return bytes;
  }
}

}  // namespace gyro
