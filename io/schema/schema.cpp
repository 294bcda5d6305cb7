// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/schema.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace gyro {
namespace {

/// A limit in a message, with its unit: 0.5, 1000000, 1.0e-09 m.
std::string limit_text(double value, Dimension dimension) {
  const std::string_view unit = si_unit(dimension);
  const bool whole = std::abs(value) < 1e16 && value == std::floor(value);
  std::string text = whole ? std::to_string(static_cast<long long>(value)) : number_text(value);
  return unit == "1" || value == 0 ? text : text + " " + std::string(unit);
}

/// Optimal string alignment distance: number of insertions, deletions, substitutions and swaps of adjacent letters.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    std::swap(above, row);
  }
  return above[b.size()];
}

bool is_placeholder(std::string_view part) {
  return part.starts_with('<');
}

}  // namespace

std::string_view Key::name() const {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::string_view Key::parent() const {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

std::vector<const Key*> keys_below(std::string_view section) {
  std::vector<const Key*> found;
  for (const Key& key : schema_keys())
    if (key.parent() == section) found.push_back(&key);
  return found;
}

const Key* find_key(std::string_view path) {
  for (const Key& key : schema_keys())
    if (key.path == path) return &key;
  return nullptr;
}

const Key* match_key(std::string_view path) {
  const std::vector<std::string_view> parts = split(path, '.');
  for (const Key& key : schema_keys()) {
    const std::vector<std::string_view> pattern = split(key.path, '.');
    const auto same = [](std::string_view p, std::string_view x) { return p == x || is_placeholder(p); };
    if (std::equal(pattern.begin(), pattern.end(), parts.begin(), parts.end(), same)) return &key;
  }
  return nullptr;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  if (text.empty()) return parts;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find(separator, begin)) != std::string_view::npos; begin = end + 1)
    parts.push_back(text.substr(begin, end - begin));
  parts.push_back(text.substr(begin));
  return parts;
}

std::string range_text(const Range& range, Dimension dimension) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  if (low && high && range.low == range.high) return "exactly " + limit_text(range.low, dimension);
  if (low && high && !range.low_open && !range.high_open)
    return "between " + limit_text(range.low, dimension) + " and " + limit_text(range.high, dimension);
  std::string text;
  if (low) text = (range.low_open ? "> " : ">= ") + limit_text(range.low, dimension);
  if (low && high) text += " and ";
  if (high) text += (range.high_open ? "< " : "<= ") + limit_text(range.high, dimension);
  return text;
}

std::string number_text(double value) {
  char buffer[40];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  std::string text(buffer, end);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) text.insert(exponent, ".0");
  return text;
}

std::string_view closest(std::string_view word, const std::vector<std::string_view>& candidates) {
  std::string_view best;
  std::size_t minimum = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const std::string_view candidate : candidates) {
    std::size_t distance = edit_distance(word, candidate);
    // The word may lack only its beginning or end, such as `stiffness` for `shear_stiffness`.
    if (word.size() >= 4 && (candidate.starts_with(word) || candidate.ends_with(word)))
      distance = std::min<std::size_t>(distance, 2);
    if (distance < minimum && distance < candidate.size()) {
      minimum = distance;
      best = candidate;
    }
  }
  return best;
}

const Setting* Setting::find(std::string_view path) const {
  const std::size_t dot = path.find('.');
  for (const Setting& child : children) {
    if (child.name != path.substr(0, dot)) continue;
    return dot == std::string_view::npos ? &child : child.find(path.substr(dot + 1));
  }
  return nullptr;
}

const Setting& Setting::needed(std::string_view path) const {
  if (const Setting* found = find(path)) return *found;
  throw std::logic_error("the setting " + name + " has no " + std::string(path));
}

bool Setting::lacks(std::string_view child) const {
  return find(child) == nullptr && std::find(lost.begin(), lost.end(), child) == lost.end();
}

}  // namespace gyro
