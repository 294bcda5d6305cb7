// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/encoding.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace gyro {

/// A text for a message: bytes that are not UTF-8, and control characters except line feed and tab, become \xNN. What
/// a message quotes of a file could otherwise end it (a zero byte), change the terminal, or not fit into JSON.
inline std::string printable(std::string_view text) {
  constexpr const char* digits = "0123456789ABCDEF";
  std::string shown;
  while (!text.empty()) {
    const auto byte = static_cast<unsigned char>(text.front());
    std::size_t length = utf8_length(text);
    const bool control = byte < 0x20 ? byte != '\n' && byte != '\t' : byte == 0x7F;
    const bool high_control = length == 2 && byte == 0xC2 && static_cast<unsigned char>(text[1]) < 0xA0;
    if (length == 0 || control || high_control) {
      length = 1;
      shown += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    } else {
      shown += text.substr(0, length);
    }
    text.remove_prefix(length);
  }
  return shown;
}

}  // namespace gyro
