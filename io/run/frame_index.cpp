// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/frame_index.hpp"

#include "core/base/errors.hpp"
#include "io/run/replace_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

namespace gyro {
namespace {

constexpr std::string_view head =
    "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
    "  <Collection>\n";
constexpr std::string_view tail = "  </Collection>\n</VTKFile>\n";

std::string lines_of(double time, std::span<const std::string> parts) {
  std::array<char, 32> number;
  std::snprintf(number.data(), number.size(), "%.12g", time);
  std::string lines;
  for (std::size_t part = 0; part < parts.size(); ++part)
    lines += "    <DataSet timestep=\"" + std::string(number.data()) + "\" part=\"" + std::to_string(part) +
             "\" file=\"" + parts[part] + "\"/>\n";
  return lines;
}

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

void FrameIndex::write(std::span<const double> times, std::span<const std::vector<std::string>> parts) {
  std::string text(head);
  for (std::size_t frame = 0; frame < times.size(); ++frame) text += lines_of(times[frame], parts[frame]);
  end_ = text.size();
  replace_file(file_, text.append(tail));
}

void FrameIndex::add(double time, std::span<const std::string> parts) {
  if (end_ == 0) {
    const std::vector<std::string> first(parts.begin(), parts.end());
    return write({&time, 1}, {&first, 1});
  }
  const std::string lines = lines_of(time, parts);
  const int file = ::open(file_.c_str(), O_WRONLY | O_CLOEXEC);
  const bool written = file >= 0 && write_at(file, lines + std::string(tail), end_);
  const int reason = errno;
  if (file >= 0) {
    // On a full disk the old end still fits into its former place.
    if (!written) [[maybe_unused]]
      const bool restored =
          write_at(file, tail, end_) && ::ftruncate(file, static_cast<off_t>(end_ + tail.size())) == 0;
    ::close(file);
  }
  if (!written) throw OutputError(file_.string() + ": cannot write: " + std::generic_category().message(reason));
  end_ += lines.size();
}

}  // namespace gyro
