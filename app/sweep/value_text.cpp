// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/value_text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <string_view>

namespace gyro {
namespace {

/// Whether a text stays a text without quotes, also within a list. Texts that YAML might read otherwise are quoted.
bool is_plain(std::string_view text) {
  const auto harmless = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_./+%- ").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (text.empty() || text.front() == ' ' || text.back() == ' ' || text == "-" || text.starts_with("- ")) return false;
  if (text == "null" || text == "Null" || text == "NULL" || text.starts_with("---") || text.starts_with("..."))
    return false;
  return text.front() != '%' && std::all_of(text.begin(), text.end(), harmless);
}

std::string quoted(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    char code[8];
    std::snprintf(code, sizeof code, "\\x%02x", static_cast<unsigned>(byte));
    if (byte < 0x20 || byte == 0x7f)
      result += code;
    else
      result += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  }
  return result + '"';
}

std::string text_of(std::string_view text) {
  return is_plain(text) ? std::string(text) : quoted(text);
}

}  // namespace

std::string value_text(const YamlNode& node) {
  std::string text;
  switch (node.kind) {
    case YamlNode::Kind::null:
      return "null";
    case YamlNode::Kind::scalar:
      return text_of(node.text);
    case YamlNode::Kind::list:
      for (const YamlNode& item : node.items) text += (text.empty() ? "" : ", ") + value_text(item);
      return "[" + text + "]";
    case YamlNode::Kind::map:
      for (const YamlEntry& entry : node.entries)
        text += (text.empty() ? "" : ", ") + text_of(entry.key) + ": " + value_text(entry.value);
      return "{" + text + "}";
  }
  return text;
}

}  // namespace gyro
