// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/case/parts.hpp"
#include "io/files/digest.hpp"
#include "io/files/read_file.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>

// Whether a run may continue with a case: compares the case of its checkpoint with the case that is given now.

namespace gyro {
namespace {

/// Value of a node on one line.
std::string value_text(const YamlNode& node) {
  if (node.kind != YamlNode::Kind::list) return node.kind == YamlNode::Kind::map ? "{}" : node.text;
  std::string text = "[";
  for (const YamlNode& item : node.items) text += (text.size() > 1 ? ", " : "") + value_text(item);
  return text + "]";
}

void flatten(const YamlNode& node, const std::string& path, std::map<std::string, std::string>& values) {
  if (node.kind != YamlNode::Kind::map || node.entries.empty()) {
    values[path] = value_text(node);
    return;
  }
  for (const YamlEntry& entry : node.entries)
    flatten(entry.value, path.empty() ? entry.key : path + "." + entry.key, values);
}

/// Keys that may change when a run continues. The other keys of `output` decide which columns the results have.
constexpr std::array<std::string_view, 4> free_keys{"time.duration", "output.series", "output.snapshots",
                                                    "output.checkpoints"};

std::map<std::string, std::string> values_of(const std::string& resolved) {
  std::map<std::string, std::string> values;
  flatten(parse_yaml(resolved).root, "", values);
  std::erase_if(values, [](const auto& value) { return std::ranges::find(free_keys, value.first) != free_keys.end(); });
  return values;
}

/// Whether a key is the section or lies in it; "" is the whole case.
bool lies_in(const std::string& section, const std::string& key) {
  return section.empty() || key == section || key.starts_with(section + ".");
}

}  // namespace

std::optional<CaseDifference> difference_in(const std::string& section, const std::string& resolved,
                                            const std::string& other) {
  const std::map<std::string, std::string> a = values_of(resolved), b = values_of(other);
  const auto value = [](const auto& values, const std::string& key) {
    const auto found = values.find(key);
    return found != values.end() ? found->second : "absent";
  };
  for (const auto* values : {&a, &b})
    for (const auto& [key, text] : *values)
      if (lies_in(section, key) && value(a, key) != value(b, key))
        return CaseDifference{key, value(a, key), value(b, key)};
  return {};
}

std::optional<CaseDifference> difference(const std::string& resolved, const std::string& other) {
  return difference_in("", resolved, other);
}

bool has_key(const std::string& resolved, const std::string& key) {
  for (const auto& [known, value] : values_of(resolved))
    if (lies_in(key, known)) return true;
  return false;
}

std::string input_digests(const Setting& setting, CaseProblems& problems) {
  std::string lines;
  const KeyType type = setting.key ? setting.key->type : KeyType::section;
  if (type == KeyType::file || type == KeyType::files)
    for (const std::string& file : setting.texts) try {
        lines += digest_of(read_file(file)) + " " + file + "\n";
      } catch (const UnreadableFile& unreadable) {
        problems.add_in_file(file, 1, 1, unreadable.problem);
      }
  for (const Setting& child : setting.children) lines += input_digests(child, problems);
  return lines;
}

}  // namespace gyro
