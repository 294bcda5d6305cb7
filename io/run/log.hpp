// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace gyro {

/// The log of a run. All messages are written to a file with date and time; warnings and errors are also written to
/// standard error. Several threads may use it at the same time.
class Log {
 public:
  /// Appends to `file`. @throws OutputError if it cannot be opened
  explicit Log(const std::filesystem::path& file);
  /// Without a file: warnings and errors are written to standard error only.
  Log();
  ~Log();
  Log(Log&&) noexcept;
  Log& operator=(Log&&) noexcept;

  void info(std::string_view message);
  void warning(std::string_view message);
  void error(std::string_view message);

 private:
  struct Sinks;
  std::unique_ptr<Sinks> sinks_;
};

}  // namespace gyro
