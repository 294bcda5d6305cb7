// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

namespace gyro {

/// The log of a run: everything into a file with the time of day, warnings and errors also to standard
/// error. Safe to call from several threads.
class Log {
 public:
  /// Appends to `file`. @throws OutputError when it cannot be opened
  explicit Log(const std::filesystem::path& file);
  /// Without a file: warnings and errors to standard error only.
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
