// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/index_file.hpp"

#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace gyro {
namespace {

/// Writes a text at a place of a file [bytes]. @returns false on failure, with errno
bool write_at(int file, std::string_view text, std::size_t place) {
  while (!text.empty()) {
    const ssize_t written = ::pwrite(file, text.data(), text.size(), static_cast<off_t>(place));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
    place += static_cast<std::size_t>(written);
  }
  return true;
}

}  // namespace

void IndexFile::write(std::span<const std::string> frames) {
  std::string text = head_;
  for (const std::string& frame : frames) text += frame;
  end_ = text.size();
  replace_file(path_, text.append(tail_));
}

void IndexFile::add(std::string_view frame) {
  if (end_ == 0) {
    const std::string first(frame);
    return write({&first, 1});
  }
  const int file = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
  const bool written = file >= 0 && write_at(file, std::string(frame) + tail_, end_);
  const int reason = errno;
  if (file >= 0) {
    // On a full disk the old end still fits into its former place.
    if (!written) [[maybe_unused]]
      const bool restored =
          write_at(file, tail_, end_) && ::ftruncate(file, static_cast<off_t>(end_ + tail_.size())) == 0;
    ::close(file);
  }
  if (!written) throw OutputError(path_.string() + ": cannot write: " + std::generic_category().message(reason));
  end_ += frame.size();
}

}  // namespace gyro
