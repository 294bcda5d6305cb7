// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

namespace gyro {

/// Length of the UTF-8 sequence at the front of a text; 0 if there is a zero byte or bytes that are not UTF-8 (RFC
/// 3629: no overlong forms, no surrogates, nothing above U+10FFFF).
inline std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const auto follows = [&](std::size_t k, unsigned low = 0x80, unsigned high = 0xBF) {
    return byte(k) >= low && byte(k) <= high;
  };
  const unsigned lead = byte(0);
  if (lead == 0) return 0;
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return follows(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const unsigned low = lead == 0xE0 ? 0xA0 : 0x80, high = lead == 0xED ? 0x9F : 0xBF;
    return follows(1, low, high) && follows(2) ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const unsigned low = lead == 0xF0 ? 0x90 : 0x80, high = lead == 0xF4 ? 0x8F : 0xBF;
    return follows(1, low, high) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

/// Whether bytes are a text in UTF-16 or UTF-32, as some editors and spreadsheets save it: they begin with its
/// byte-order mark, or every second byte of the beginning is zero and the others are not.
inline bool is_utf16(std::string_view bytes) {
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
  if (bytes.starts_with(std::string_view("\0\0\xFE\xFF", 4))) return true;
  const std::string_view begin = bytes.substr(0, 64);
  if (begin.size() < 4) return false;
  for (const std::size_t zeros : {0u, 1u}) {
    bool all = true;
    for (std::size_t k = 0; k < begin.size(); ++k) all &= (begin[k] == '\0') == (k % 2 == zeros);
    if (all) return true;
  }
  return false;
}

/// What is wrong with such a file, and what to do.
constexpr const char* utf16_problem = "is a text in UTF-16; save it as UTF-8";

}  // namespace gyro
