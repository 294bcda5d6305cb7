// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/replace_file.hpp"

#include "core/base/errors.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

namespace gyro {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* what) {
  throw OutputError(path.string() + ": cannot " + what + ": " + std::generic_category().message(errno));
}

/// Writes the whole content. One call of write() may write only a part of it; this is not an error.
bool write_all(int file, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(file, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view content, bool sync) {
  const std::string part = path.string() + ".tmp";
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail(path, "create the file");
  const bool written = write_all(file, content) && (!sync || ::fsync(file) == 0);
  const int reason = errno;
  const bool closed = ::close(file) == 0;  // some file systems report a full disk only here
  if (!written || !closed) {
    if (!written) errno = reason;
    const int kept = errno;
    ::unlink(part.c_str());
    errno = kept;
    fail(path, "write");
  }
  if (std::rename(part.c_str(), path.c_str()) != 0) fail(path, "replace the file");
}

void sync_file(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail(path, "open the file");
  const bool synced = ::fsync(file) == 0;
  const int reason = errno;
  ::close(file);
  errno = reason;
  if (!synced) fail(path, "write");
}

void put_in_place(const std::filesystem::path& path) {
  const std::filesystem::path part = path.string() + ".tmp";
  sync_file(part);
  if (std::rename(part.c_str(), path.c_str()) != 0) fail(path, "replace the file");
}

}  // namespace gyro
