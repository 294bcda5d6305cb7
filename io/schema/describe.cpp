// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "io/case/case.hpp"
#include "io/schema/values.hpp"

namespace gyro {
namespace {

/// `quantity [m], more than 0 m; default 0.5 ms`
std::string properties_of(const Key& key) {
  std::string text;
  switch (key.type) {
    case KeyType::section:
      text = key.words.empty() ? "section" : "one of " + choice(split(key.words, '|')) + ", or a section";
      break;
    case KeyType::named:
      text = "section of names";
      break;
    case KeyType::quantity:
      text = "quantity";
      break;
    case KeyType::integer:
      text = "whole number";
      break;
    case KeyType::text:
      text = "text";
      break;
    case KeyType::word:
      text = "one of " + choice(split(key.words, '|'));
      break;
    case KeyType::file:
      text = "path of a file";
      break;
    case KeyType::vector:
      text = "list of three quantities";
      break;
    case KeyType::interval:
      text = "list of two quantities, the second larger";
      break;
    case KeyType::integers:
      text = "list of whole numbers";
      break;
    case KeyType::words:
      text = "list of " + choice(split(key.words, '|'));
      break;
    case KeyType::files:
      text = "list of paths";
      break;
    case KeyType::passing:
      text = "list of pairs";
      break;
    case KeyType::values:
      text = "map of names to numbers or truth values";
      break;
  }
  const bool measured = key.type == KeyType::quantity || key.type == KeyType::vector || key.type == KeyType::interval ||
                        key.type == KeyType::passing;
  if (measured) text += " [" + std::string(si_unit(key.dimension)) + "]";
  if (key.type == KeyType::quantity && !key.words.empty()) text += " or " + choice(split(key.words, '|'));
  if (const std::string range = range_text(key.range, key.dimension); !range.empty()) text += ", " + range;
  if (!key.one_of.empty()) {
    std::string groups;
    for (const std::string_view group : split(key.one_of, '|'))
      groups += (groups.empty() ? "" : " | ") + std::string(group);
    text += " with exactly one of " + groups;
  }
  const bool beside = !key.when.empty() && key.when.find('=') == std::string_view::npos;
  std::string condition;
  if (beside)
    condition = key.when.starts_with('!') ? ", without " + std::string(key.when.substr(1))
                                          : ", beside " + std::string(key.when);
  if (!key.fallback.empty()) return text + "; default " + std::string(key.fallback) + condition;
  if (!key.when.empty() && !beside) return text + "; required with " + std::string(key.when);
  if (key.required) return text + "; required" + condition;
  return text + (key.defaulted ? "; all its keys have defaults" : "; optional") + condition;
}

std::string entry_of(const Key& key) {
  return std::string(key.path) + "\n    " + properties_of(key) + "\n    " + std::string(key.doc) + "\n";
}

/// Units of a dimension other than its SI unit: `mm, cm, ...`
std::string units_of(Dimension dimension) {
  std::string list;
  for (const Unit& unit : units())
    if (unit.dimension == dimension && unit.name != "1") list += (list.empty() ? "" : ", ") + std::string(unit.name);
  return list;
}

[[noreturn]] void refuse(const std::string& key) {
  std::vector<std::string_view> paths;
  for (const Key& known : schema_keys()) paths.push_back(known.path);
  std::string_view meant = closest(key, paths);
  const std::string last = key.substr(key.rfind('.') + 1);
  for (const Key& known : schema_keys())
    if (meant.empty() && known.name() == last) meant = known.path;
  throw BadInput("there is no key " + in_quotes(key) + " in a case; " +
                 (meant.empty() ? "" : "did you mean " + in_quotes(meant) + "? ") +
                 "a path as time.duration is accepted, `gyrosim describe` lists them all");
}

}  // namespace

std::string describe(const std::string& key) {
  const std::string head =
      "A quantity is a plain number in the unit in brackets, or a text with a unit, as 120 mm.\n"
      "Paths of files are relative to the case file; <name> and <pair> stand for names of your own.\n\n";
  if (key.empty()) {
    std::string text = head;
    for (const Key& known : schema_keys()) text += entry_of(known);
    return text;
  }
  const Key* found = match_key(key);
  std::string text = found == nullptr ? "" : entry_of(*found);
  // `materials.rock` is no key of the table, but its keys are.
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
