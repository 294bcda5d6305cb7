// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/printable.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"

using namespace gyro;

TEST_CASE("Control characters and bytes that are no UTF-8 are written as numbers", "[base]") {
  CHECK(printable("a\tb\nc \xC3\xA4 \xE2\x82\xAC") == "a\tb\nc \xC3\xA4 \xE2\x82\xAC");
  CHECK(printable(std::string_view("a\0b", 3)) == "a\\x00b");
  CHECK(printable("\x1b[31m\x7f\r") == "\\x1B[31m\\x7F\\x0D");
  CHECK(printable("\xE4\xC3") == "\\xE4\\xC3");
  CHECK(printable("\xC2\x9B") == "\\xC2\\x9B");  // a control character of two bytes
  CHECK(std::string(BadInput(std::string("name\0rest", 9)).what()) == "name\\x00rest");
}

TEST_CASE("UTF-16 is known by its mark or its zeros", "[base]") {
  CHECK(is_utf16("\xFF\xFE"));
  CHECK(is_utf16("\xFE\xFF"));
  CHECK(is_utf16(std::string_view("t\0i\0m\0e\0", 8)));
  CHECK(is_utf16(std::string_view("\0t\0i\0m\0e", 8)));
  CHECK_FALSE(is_utf16("time: 1"));
  CHECK_FALSE(is_utf16(""));
  CHECK_FALSE(is_utf16(std::string_view("ab\0\0", 4)));
}
