// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/run_end.hpp"

#include "io/yaml/units.hpp"

#include <algorithm>
#include <string_view>

namespace gyro {
namespace {

constexpr std::string_view steady = "steady";
constexpr double usual_error = 0.05;

ParsedRunEnd parse_time(const std::string& text) {
  const ParsedNumber parsed = parse_quantity(text, Dimension::time);
  if (!parsed.value) return {.problem = parsed.problem};
  if (!(*parsed.value >= 0)) return {.problem = "must be >= 0"};
  return {.end = RunEnd{.until = parsed.value}};
}

}  // namespace

ParsedRunEnd parse_run_end(const std::string& text) {
  if (!text.starts_with(steady)) return parse_time(text);
  if (text == steady) return {.end = RunEnd{.steady = usual_error}};
  const ParsedNumber parsed = parse_quantity(text.substr(std::min(steady.size() + 1, text.size())), Dimension::number);
  if (text[steady.size()] != '=' || !parsed.value || !(*parsed.value > 0 && *parsed.value < 1))
    return {.problem = text +
                       " is not an end; give a time, steady, or steady=ERROR with a relative standard error between 0 "
                       "and 1, such as steady=5%"};
  return {.end = RunEnd{.steady = parsed.value}};
}

}  // namespace gyro
