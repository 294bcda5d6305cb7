// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/describe.hpp"
#include "core/base/errors.hpp"
#include "io/schema/values.hpp"

namespace gyro {
namespace {

/// What the value of a key looks like: `one of mixed or double`, `list of three quantities`.
std::string kind_of(const Key& key) {
  const std::string words = choice(split(key.words, '|'));
  switch (key.type) {
    case KeyType::section:
      return words.empty() ? "section" : "one of " + words + ", or a section";
    case KeyType::named:
      return "section of names";
    case KeyType::quantity:
      return "quantity";
    case KeyType::integer:
      return "whole number";
    case KeyType::text:
      return "text";
    case KeyType::word:
      return "one of " + words;
    case KeyType::file:
      return "path of a file";
    case KeyType::vector:
      return "list of three quantities";
    case KeyType::interval:
      return "list of two quantities, the second larger";
    case KeyType::quantities:
      return "list of increasing quantities";
    case KeyType::integers:
      return "list of whole numbers";
    case KeyType::words:
      return "list of " + words;
    case KeyType::files:
      return "list of paths";
    case KeyType::passing:
      return "list of pairs";
    case KeyType::values:
      return "map of names to numbers or truth values";
  }
  return {};
}

/// Unit, words beside the number, and range: ` [s] or auto, > 0`.
std::string limits_of(const Key& key) {
  const bool measured = key.type == KeyType::quantity || key.type == KeyType::vector || key.type == KeyType::interval ||
                        key.type == KeyType::quantities || key.type == KeyType::passing;
  std::string text = measured ? " [" + std::string(si_unit(key.dimension)) + "]" : "";
  if (key.type == KeyType::quantity && !key.words.empty()) text += " or " + choice(split(key.words, '|'));
  if (const std::string range = range_text(key.range, key.dimension); !range.empty()) text += ", " + range;
  return text;
}

/// Groups of keys of which a section must have exactly one: ` with exactly one of relative | absolute`.
std::string alternatives_of(const Key& key) {
  std::string groups;
  for (const std::string_view group : split(key.one_of, '|'))
    groups += (groups.empty() ? " with exactly one of " : " | ") + std::string(group);
  return groups;
}

/// Default, or whether the key is required, and the other key that it depends on: `; default 0.5 ms, without fmu`.
std::string presence_of(const Key& key) {
  const bool needs_word = key.when.find('=') != std::string_view::npos;
  std::string neighbour;
  if (!key.when.empty() && !needs_word)
    neighbour =
        key.when.starts_with('!') ? ", without " + std::string(key.when.substr(1)) : ", with " + std::string(key.when);
  if (!key.fallback.empty()) return "; default " + std::string(key.fallback) + neighbour;
  if (needs_word) return "; required with " + std::string(key.when);
  if (key.required) return "; required" + neighbour;
  return (key.defaulted ? "; all its keys have defaults" : "; optional") + neighbour;
}

/// All properties of a key: `quantity [s], > 0; default 0.5 ms`.
std::string properties_of(const Key& key) {
  return kind_of(key) + limits_of(key) + alternatives_of(key) + presence_of(key);
}

std::string entry_of(const Key& key) {
  return std::string(key.path) + "\n    " + properties_of(key) + "\n    " + std::string(key.doc) + "\n";
}

/// All units of a dimension: `m, km, cm, ...`
std::string units_of(Dimension dimension) {
  std::string list;
  for (const Unit& unit : units())
    if (unit.dimension == dimension && unit.name != "1") list += (list.empty() ? "" : ", ") + std::string(unit.name);
  return list;
}

/// Refuses a key that does not exist, and suggests the one that was probably meant.
[[noreturn]] void refuse(const std::string& key) {
  std::vector<std::string_view> paths;
  for (const Key& known : schema_keys()) paths.push_back(known.path);
  std::string_view meant = closest(key, paths);
  const std::string last = key.substr(key.rfind('.') + 1);
  for (const Key& known : schema_keys())
    if (meant.empty() && known.name() == last) meant = known.path;
  throw BadInput("there is no key " + in_quotes(key) + " in a case; " +
                 (meant.empty() ? "" : "did you mean " + in_quotes(meant) + "? ") +
                 "`gyrosim describe` lists all keys");
}

}  // namespace

std::string describe(const std::string& key) {
  const std::string head =
      "A quantity is a plain number in the unit in brackets, or a text with a unit, such as 120 mm.\n"
      "Paths of files are relative to the case file; <name> and <pair> stand for names that you choose.\n\n";
  if (key.empty()) {
    std::string text = head;
    for (const Key& known : schema_keys()) text += entry_of(known);
    return text;
  }
  const Key* found = match_key(key);
  std::string text = found == nullptr ? "" : entry_of(*found);
  // `materials.rock` is not a key of the table, but keys below it are.
  const std::string probe = key + ".";
  for (const Key& known : schema_keys()) {
    const std::vector<std::string_view> pattern = split(known.path, '.'), parts = split(key, '.');
    if (pattern.size() <= parts.size()) continue;
    std::string above;
    for (std::size_t k = 0; k < parts.size(); ++k)
      above += std::string(pattern[k].starts_with('<') ? parts[k] : pattern[k]) + ".";
    if (above == probe) text += entry_of(known);
  }
  if (text.empty()) refuse(key);
  if (found != nullptr && found->dimension != Dimension::number)
    text += "    units: " + units_of(found->dimension) + "\n";
  return text;
}

}  // namespace gyro
