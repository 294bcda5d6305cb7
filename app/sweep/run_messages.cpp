// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run_messages.hpp"

#include "core/base/errors.hpp"
#include "core/base/printable.hpp"
#include "io/files/read_file.hpp"
#include "io/run/summary.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace gyro {

namespace fs = std::filesystem;

std::string last_line(const fs::path& file, std::uintmax_t begin) {
  std::error_code error;
  if (!fs::exists(file, error)) return {};
  std::string text = read_file(file);
  text.erase(0, std::min<std::size_t>(begin, text.size()));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return printable(text.substr(text.rfind('\n') + 1));
}

std::string reason_of(const fs::path& run, const std::string& line) {
  try {
    const std::string reason = load_summary(run).reason;
    return reason.empty() ? line : reason;
  } catch (const BadInput&) {
    return line;
  }
}

std::string placed_in_sweep(const std::string& line, const CheckedSweep& sweep, const CheckedPoint& point) {
  constexpr std::string_view label = "--set:";
  const std::vector<SweepSetting> settings = settings_of(sweep.file, point.point);
  const std::size_t number = line.starts_with(label) ? std::strtoul(line.c_str() + label.size(), nullptr, 10) : 0;
  const std::size_t problem = line.find(": ");
  if (number < 1 || number > settings.size() || problem == std::string::npos) return line;
  const Mark& mark = settings[number - 1].value_mark;
  return to_string(CaseProblem{sweep.file.file.string(), mark.line, mark.column, line.substr(problem + 2)});
}

}  // namespace gyro
