// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/point_names.hpp"

#include "io/files/digest.hpp"
#include "io/schema/schema.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace gyro {
namespace {

constexpr std::size_t longest_value = 24, longest_name = 100;  // [characters] before the digest

bool is_safe(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '.' || c == '+' || c == '-';
}

std::string with_digest(const std::string& text, std::size_t length, const std::string& of) {
  return text.substr(0, length) + "-" + digest_of(of).substr(0, 8);
}

/// The last parts of a key: "radius.relative".
std::string last_parts(const std::string& key, std::size_t count) {
  const std::vector<std::string_view> parts = split(key, '.');
  std::string text;
  for (std::size_t k = parts.size() - std::min(count, parts.size()); k < parts.size(); ++k)
    text += (text.empty() ? "" : ".") + std::string(parts[k]);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return !is_safe(c) && c != '_'; }, '-');
  return text;
}

}  // namespace

std::vector<std::string> short_names(const std::vector<std::string>& keys,
                                     const std::map<std::string, std::string>& given) {
  std::vector<std::string> names(keys.size());
  for (std::size_t k = 0; k < keys.size(); ++k) {
    if (const auto found = given.find(keys[k]); found != given.end()) {
      names[k] = found->second;
      continue;
    }
    for (std::size_t count = 1; count <= split(keys[k], '.').size(); ++count) {
      names[k] = last_parts(keys[k], count);
      const auto same = [&](const std::string& other) {
        return other != keys[k] && !given.contains(other) && last_parts(other, count) == names[k];
      };
      if (std::none_of(keys.begin(), keys.end(), same)) break;
    }
  }
  return names;
}

std::string value_in_name(const std::string& value) {
  std::string text;
  bool lossy = std::count(value.begin(), value.end(), '[') > 1;  // lists in a list
  for (const char c : value) {
    if (std::string_view(" \"[]").find(c) != std::string_view::npos) continue;
    lossy |= !is_safe(c) && c != ',';
    text += is_safe(c) ? c : c == ',' ? '+' : '-';
  }
  return lossy || text.empty() || text.size() > longest_value ? with_digest(text, longest_value, value) : text;
}

std::string setting_name(const std::vector<std::string>& names, const SweepPoint& point) {
  std::string text;
  for (std::size_t k = 0; k < point.varied.size(); ++k)
    text += (k == 0 ? "" : "_") + names[k] + "-" + value_in_name(point.varied[k].value);
  return text.size() > longest_name ? with_digest(text, longest_name - 9, text) : text;
}

std::string point_name(const std::string& setting, std::uint64_t seed) {
  return (setting.empty() ? "" : setting + "_") + "seed-" + std::to_string(seed);
}

}  // namespace gyro
