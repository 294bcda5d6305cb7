// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/read_file.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <system_error>

namespace gyro {
namespace {

/// A file that is open for reading.
class OpenFile {
 public:
  explicit OpenFile(const std::filesystem::path& path) : path_(path) {
    descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("check its permissions");
  }
  ~OpenFile() { ::close(descriptor_); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// Reads at most `size` bytes. @return number of bytes read; 0 at the end
  std::size_t read(char* bytes, std::size_t size) const {
    for (;;) {
      const ssize_t got = ::read(descriptor_, bytes, size);
      if (got >= 0) return static_cast<std::size_t>(got);
      if (errno != EINTR) fail("check the disk, or copy the file again");
    }
  }

 private:
  [[noreturn]] void fail(const char* advice) const {
    throw UnreadableFile(path_, "cannot be read: " + std::generic_category().message(errno) + "; " + advice);
  }

  const std::filesystem::path& path_;
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
  const OpenFile file(path);
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
