// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/shell_text.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace gyro {

std::string shell_word(const std::string& word) {
  const auto safe = [](unsigned char c) {
    return std::isalnum(c) || std::string_view("_./+-:=,@%").find(static_cast<char>(c)) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), safe)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return text + "'";
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
  return line;
}

}  // namespace gyro
