// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/log.hpp"

#include "core/base/errors.hpp"

#include <spdlog/logger.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_sinks.h>
#include <unistd.h>
#include <cstdio>

namespace gyro {

struct Log::Sinks {
  spdlog::logger logger{"gyrosim"};
};

Log::Log() : sinks_(std::make_unique<Sinks>()) {
  const auto terminal = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  terminal->set_level(spdlog::level::warn);
  // On a terminal the live progress line may be in the place of the message, so that it is erased first.
  terminal->set_pattern(::isatty(STDERR_FILENO) ? "\r\033[K%l: %v" : "%l: %v");
  sinks_->logger.sinks().push_back(terminal);
  sinks_->logger.flush_on(spdlog::level::info);
  sinks_->logger.set_error_handler([](const std::string& reason) { throw OutputError("log.txt: " + reason); });
}

Log::Log(const std::filesystem::path& file) : Log() {
  try {
    const auto sink = std::make_shared<spdlog::sinks::basic_file_sink_mt>(file.string());
    sink->set_pattern("%Y-%m-%d %H:%M:%S.%e %l: %v");
    sinks_->logger.sinks().push_back(sink);
  } catch (const spdlog::spdlog_ex& error) {
    throw OutputError(file.string() + ": cannot open the log: " + error.what());
  }
}

Log::~Log() = default;
Log::Log(Log&&) noexcept = default;
Log& Log::operator=(Log&&) noexcept = default;

void Log::info(std::string_view message) {
  sinks_->logger.info(message);
}

void Log::warning(std::string_view message) {
  sinks_->logger.warn(message);
}

void Log::error(std::string_view message) {
  sinks_->logger.error(message);
}

}  // namespace gyro
