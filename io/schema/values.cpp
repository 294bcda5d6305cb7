// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

using Kind = YamlNode::Kind;

/// No machine has more; a larger value is a mistake in the unit [SI]. Infinite where there is no such limit.
double largest_of(Dimension dimension) {
  switch (dimension) {
    case Dimension::torque:
    case Dimension::power:
    case Dimension::inertia:
      return 1e12;
    case Dimension::angular_speed:
      return 1e6;
    default:
      return std::numeric_limits<double>::infinity();
  }
}

bool contains(const std::vector<std::string_view>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

std::string in_quotes(std::string_view text) {
  return '"' + std::string(text) + '"';
}

std::string choice(const std::vector<std::string_view>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k)
    text += (k == 0 ? "" : k + 1 == words.size() ? " or " : ", ") + std::string(words[k]);
  return text;
}

bool ValueReader::wrong_form(const Key& key, const YamlNode& node, const std::string& path) {
  static constexpr std::string_view names[] = {"nothing", "a single value", "a list", "a map of keys"};
  problem(node.mark, path + " is " + std::string(names[static_cast<int>(node.kind)]) + "; give " + form_of(key));
  return false;
}

bool ValueReader::read(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  switch (key.type) {
    case KeyType::quantity:
      if (node.kind == Kind::scalar && contains(split(key.words, '|'), node.text)) {
        setting.texts = {node.text};
        return true;
      }
      return read_number(setting, key, node, path);
    case KeyType::integer:
      return read_number(setting, key, node, path);
    case KeyType::word:
      return read_word(setting, key, node, path);
    case KeyType::vector:
      return read_numbers(setting, key, node, path, 3);
    case KeyType::interval:
      return read_interval(setting, key, node, path);
    case KeyType::quantities:
      return read_quantities(setting, key, node, path);
    case KeyType::integers:
      return read_integers(setting, key, node, path);
    case KeyType::words:
    case KeyType::files:
      return read_texts(setting, key, node, path);
    case KeyType::passing:
      return read_passing(setting, key, node, path);
    default:
      return read_text(setting, key, node, path);
  }
}

bool ValueReader::read_text(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::scalar) return wrong_form(key, node, path);
  if (node.text.empty() || node.text.find('\0') != std::string::npos) {
    problem(node.mark, path + " is empty; give " + form_of(key));
    return false;
  }
  setting.texts.push_back(node.text);
  return true;
}

bool ValueReader::read_word(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::scalar) return wrong_form(key, node, path);
  const std::vector<std::string_view> words = split(key.words, '|');
  if (std::find(words.begin(), words.end(), node.text) == words.end()) {
    const std::string_view meant = closest(node.text, words);
    problem(node.mark, path + " = " + in_quotes(node.text) + " is not known; " +
                           (meant.empty() ? "" : "did you mean " + in_quotes(meant) + "? ") + "use " + form_of(key));
    return false;
  }
  setting.texts.push_back(node.text);
  return true;
}

bool ValueReader::read_number(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::scalar) return wrong_form(key, node, path);
  const ParsedNumber parsed = key.type == KeyType::integer || key.type == KeyType::integers
                                  ? parse_integer(node.text)
                                  : parse_quantity(node.text, key.dimension);
  if (!parsed.value) {
    const std::string word = key.words.empty() ? "" : ", or " + choice(split(key.words, '|'));
    problem(node.mark, path + ": " + parsed.problem + word);
    return false;
  }
  if (!key.range.holds(*parsed.value)) {
    problem(node.mark,
            path + " = " + node.text + " is out of range; it must be " + range_text(key.range, key.dimension));
    return false;
  }
  if (key.dimension == Dimension::length && !std::isfinite(key.range.high) &&
      std::abs(*parsed.value) > longest_length) {
    problem(node.mark, path + " = " + node.text + " is more than 1 km; check the unit");
    return false;
  }
  if (const double largest = largest_of(key.dimension); std::abs(*parsed.value) > largest) {
    problem(node.mark, path + " = " + node.text + " is more than " + number_text(largest) + " " +
                           std::string(si_unit(key.dimension)) + ", which no machine has; check the unit");
    return false;
  }
  setting.numbers.push_back(*parsed.value);
  setting.item_marks.push_back(node.mark);
  return true;
}

bool ValueReader::read_numbers(Setting& setting, const Key& key, const YamlNode& node, const std::string& path,
                               std::size_t count) {
  if (node.kind != Kind::list || node.items.size() != count) return wrong_count(key, node, path);
  bool good = true;
  for (std::size_t k = 0; k < count; ++k)
    good &= read_number(setting, key, node.items[k], path + "[" + std::to_string(k) + "]");
  return good;
}

bool ValueReader::wrong_count(const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::list) return wrong_form(key, node, path);
  problem(node.mark, path + " has " + std::to_string(node.items.size()) + " items; give " + form_of(key));
  return false;
}

bool ValueReader::read_interval(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (!read_numbers(setting, key, node, path, 2)) return false;
  if (setting.numbers[0] < setting.numbers[1]) return true;
  problem(node.mark, path + " does not rise; the second value must be larger than the first");
  return false;
}

bool ValueReader::read_quantities(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::list || node.items.size() < 2) return wrong_count(key, node, path);
  if (!read_numbers(setting, key, node, path, node.items.size())) return false;
  for (std::size_t k = 1; k < setting.numbers.size(); ++k)
    if (!(setting.numbers[k - 1] < setting.numbers[k])) {
      problem(node.items[k].mark, path + " does not rise here; each value must be larger than the one before");
      return false;
    }
  return true;
}

bool ValueReader::read_integers(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::list || node.items.empty()) return wrong_count(key, node, path);
  bool good = true;
  for (const YamlNode& item : node.items) {
    good &= read_number(setting, key, item, path);
    if (good && std::count(setting.numbers.begin(), setting.numbers.end(), setting.numbers.back()) > 1) {
      problem(item.mark, path + " has " + item.text + " twice; give each value once");
      good = false;
    }
  }
  return good;
}

bool ValueReader::read_texts(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::list || node.items.empty()) return wrong_count(key, node, path);
  bool good = true;
  for (const YamlNode& item : node.items) {
    if (item.kind == Kind::scalar &&
        std::find(setting.texts.begin(), setting.texts.end(), item.text) != setting.texts.end()) {
      problem(item.mark, path + " has " + in_quotes(item.text) + " twice; give each value once");
      good = false;
      continue;
    }
    good &= key.type == KeyType::words ? read_word(setting, key, item, path) : read_text(setting, key, item, path);
    setting.item_marks.push_back(item.mark);
  }
  return good;
}

bool ValueReader::read_passing(Setting& setting, const Key& key, const YamlNode& node, const std::string& path) {
  if (node.kind != Kind::list || node.items.size() < 2) return wrong_count(key, node, path);
  Key share = key;
  share.dimension = Dimension::number;
  share.range = {.low = 0, .high = 1};
  Key size = key;
  size.range = {.low = 0, .low_open = true};
  bool good = true;
  for (const YamlNode& pair : node.items) {
    if (pair.kind != Kind::list || pair.items.size() != 2) {
      good = wrong_count(key, pair, path);
      continue;
    }
    good &= read_number(setting, size, pair.items[0], path);
    good &= read_number(setting, share, pair.items[1], path);
  }
  return good;
}

std::string names_below(std::string_view pattern) {
  std::vector<std::string_view> names;
  for (const Key* key : keys_below(pattern)) names.push_back(key->name());
  return choice(names);
}

std::string form_of(const Key& key) {
  switch (key.type) {
    case KeyType::section: {
      const std::string map = "a map of the keys " + names_below(key.path);
      return key.words.empty() ? map : choice(split(key.words, '|')) + " or " + map;
    }
    case KeyType::named:
      return key.path == "contacts" ? "a map of pairs such as rock/steel: {...}" : "a map of names";
    case KeyType::quantity: {
      const std::string number = std::string(name_of(key.dimension));
      return key.words.empty() ? number : number + " or " + choice(split(key.words, '|'));
    }
    case KeyType::integer:
      return "a whole number";
    case KeyType::text:
      return "a text";
    case KeyType::word:
      return choice(split(key.words, '|'));
    case KeyType::file:
      return "the path of a file";
    case KeyType::vector:
      return "a list of three values";
    case KeyType::interval:
      return "a list of two values";
    case KeyType::quantities:
      return "a list of at least two values, each larger than the one before";
    case KeyType::integers:
      return "a list of whole numbers";
    case KeyType::words:
      return "a list of " + choice(split(key.words, '|'));
    case KeyType::files:
      return "a list of paths";
    case KeyType::passing:
      return "a list of at least two pairs [size, share smaller]";
    case KeyType::values:
      return "a map of names to numbers or truth values";
  }
  return {};
}

}  // namespace gyro
