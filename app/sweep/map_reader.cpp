// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/map_reader.hpp"

#include "io/schema/values.hpp"

#include <algorithm>

namespace gyro {

void MapReader::refuse_unknown(const YamlNode& map, const std::vector<std::string_view>& names,
                               const std::string& where) {
  for (const YamlEntry& entry : map.entries) {
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    std::string message = "unknown key " + in_quotes(entry.key) + where + "; ";
    if (const std::string_view meant = closest(entry.key, names); !meant.empty())
      message += "did you mean " + in_quotes(meant) + "? ";
    else if (match_key(entry.key) != nullptr)
      message += "it is a key of the case: put it below `vary`, or below `set` for all points; ";
    problem(entry.mark, message + "valid keys: " + choice(names));
  }
}

const YamlEntry* MapReader::given(const YamlNode& map, std::string_view key, std::string_view form) {
  const YamlEntry* entry = map.find(key);
  if (entry == nullptr || entry->value.kind != YamlNode::Kind::null) return entry;
  problem(entry->mark, entry->key + " is empty; give " + std::string(form) + ", or remove it");
  return nullptr;
}

bool MapReader::has_kind(const YamlEntry& entry, YamlNode::Kind kind, std::string_view form) {
  if (entry.value.kind == kind) return true;
  problem(entry.value.mark, entry.key + " has the wrong form; give " + std::string(form));
  return false;
}

std::string MapReader::text(const YamlNode& map, std::string_view key, std::string_view form) {
  const YamlEntry* entry = given(map, key, form);
  if (entry == nullptr || !has_kind(*entry, YamlNode::Kind::scalar, form)) return {};
  const std::string& text = entry->value.text;
  const bool one_line = std::all_of(text.begin(), text.end(), [](unsigned char c) { return c >= 0x20 && c != 0x7f; });
  if (one_line && !text.empty()) return text;
  problem(entry->value.mark, entry->key + " must be a text on one line; give " + std::string(form));
  return {};
}

std::optional<std::int64_t> MapReader::integer(const YamlNode& node, const std::string& name, std::int64_t low,
                                               std::int64_t high) {
  const std::string range = "a whole number from " + std::to_string(low) + " to " + std::to_string(high);
  if (node.kind != YamlNode::Kind::scalar) return problem(node.mark, name + ": give " + range), std::nullopt;
  const ParsedNumber parsed = parse_integer(node.text);
  if (!parsed.value) return problem(node.mark, name + ": " + parsed.problem), std::nullopt;
  if (*parsed.value < static_cast<double>(low) || *parsed.value > static_cast<double>(high))
    return problem(node.mark, name + " = " + node.text + " is out of range; give " + range), std::nullopt;
  return static_cast<std::int64_t>(*parsed.value);
}

bool MapReader::case_key(const std::string& key, const Mark& mark) {
  const std::vector<std::string_view> parts = split(key, '.');
  if (key.empty() || key.find('=') != std::string::npos ||
      std::find(parts.begin(), parts.end(), std::string_view{}) != parts.end())
    return problem(mark, in_quotes(key) + " is not a key of a case; write key.path, such as bonds.radius.relative"),
           false;
  if (key == "case.seed" || key == "case")
    return problem(mark, "the seed of a point comes from `seeds`; give `seeds: [1, 2, 3]` in place of " + key), false;
  return true;
}

}  // namespace gyro
