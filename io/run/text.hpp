// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// A literal that must be given and must not be empty: a table in which a name, units or a description is missing does
/// not compile.
class Text {
 public:
  consteval Text(const char* text) : text_(text) {
    if (*text == '\0') throw "a name, units or description is empty";
  }
  constexpr operator const char*() const { return text_; }

 private:
  const char* text_;
};

}  // namespace gyro
