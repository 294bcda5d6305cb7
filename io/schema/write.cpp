// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/schema/schema.hpp"

#include <cstdio>

namespace gyro {
namespace {

/// A text in double quotes, with escapes that every YAML reader reads in the same way.
std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    char code[8];
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
      std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
      result += code;
    } else {
      result += c;
    }
  }
  return result + '"';
}

template <class Items, class Write>
std::string list(const Items& items, Write&& write) {
  std::string text = "[";
  for (std::size_t k = 0; k < items.size(); ++k) text += (k == 0 ? "" : ", ") + write(items[k]);
  return text + "]";
}

std::string value_text(const Setting& setting) {
  const auto plain = [](const std::string& word) { return word; };
  switch (setting.key->type) {
    case KeyType::integer:
      return std::to_string(static_cast<long long>(setting.numbers.at(0)));
    case KeyType::text:
    case KeyType::file:
      return quoted_text(setting.texts.at(0));
    case KeyType::files:
      return list(setting.texts, quoted_text);
    case KeyType::words:
      return list(setting.texts, plain);
    case KeyType::integers:
      return list(setting.numbers, [](double number) { return std::to_string(static_cast<long long>(number)); });
    case KeyType::vector:
    case KeyType::interval:
    case KeyType::quantities:
      return list(setting.numbers, number_text);
    case KeyType::passing: {
      std::string text = "[";
      for (std::size_t k = 0; k + 1 < setting.numbers.size(); k += 2)
        text +=
            (k == 0 ? "[" : ", [") + number_text(setting.numbers[k]) + ", " + number_text(setting.numbers[k + 1]) + "]";
      return text + "]";
    }
    default:
      return setting.texts.empty() ? number_text(setting.numbers.at(0)) : setting.texts[0];
  }
}

void write_below(const Setting& section, const std::string& indent, std::string& text) {
  for (const Setting& child : section.children) {
    const bool named_value = section.key != nullptr && section.key->type == KeyType::values;
    text += indent + (named_value ? quoted_text(child.name) : child.name) + ":";
    // Instead of a map, a section may be one of its words, such as `motion: fixed`.
    const bool map = child.texts.empty() && child.numbers.empty() &&
                     (child.key->type == KeyType::section || child.key->type == KeyType::named ||
                      child.key->type == KeyType::values);
    if (!map) {
      text += " " + value_text(child) + "\n";
    } else if (child.children.empty()) {
      text += " {}\n";
    } else {
      text += "\n";
      write_below(child, indent + "  ", text);
    }
  }
}

}  // namespace

std::string write_settings(const Setting& root) {
  std::string text;
  write_below(root, "", text);
  return text;
}

}  // namespace gyro
