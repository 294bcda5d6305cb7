// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace gyro {

/// A literal that may not be left out or be empty: a table whose name, units or description is missing does not
/// compile.
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
