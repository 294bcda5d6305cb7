// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/base64.hpp"

#include "tests/catch.hpp"

#include <string>

using namespace gyro;

TEST_CASE("Base64 of the test vectors of RFC 4648, section 10, and of bytes above 127") {
  CHECK(base64("").empty());
  CHECK(base64("f") == "Zg==");
  CHECK(base64("fo") == "Zm8=");
  CHECK(base64("foo") == "Zm9v");
  CHECK(base64("foob") == "Zm9vYg==");
  CHECK(base64("fooba") == "Zm9vYmE=");
  CHECK(base64("foobar") == "Zm9vYmFy");
  CHECK(base64("\xff\xfe\xfb\xef") == "//777w==");
}

TEST_CASE("Text of base64 gives back any bytes of any length") {
  std::string bytes;
  for (int k = 0; k < 600; ++k) {
    CHECK(from_base64(base64(bytes)) == bytes);
    bytes += static_cast<char>(k * 37 + k / 256);
  }
}

TEST_CASE("Text that is no base64 gives no bytes") {
  for (const char* text : {"Z", "Zg", "Zg=", "Zm9vYg", "Zm9vYg=", "Zm9vYmFyZ"}) {  // cut off
    INFO(text);
    CHECK_FALSE(from_base64(text));
  }
  for (const char* text : {"=", "==", "====", "Z===", "=g==", "Z=g=", "Zg==Zg==", "Zg=v"}) {  // = in a wrong place
    INFO(text);
    CHECK_FALSE(from_base64(text));
  }
  for (const char* text : {"Zm9v\n", "Zm 9", " m9v", "Zm9-", "Zm_v", "Zm9\xff", "Zm9."}) {  // other characters
    INFO(text);
    CHECK_FALSE(from_base64(text));
  }
  CHECK_FALSE(from_base64(std::string_view("Zm9\0", 4)));
  for (const char* text : {"Zh==", "Zn==", "Zm9=", "Zm//Zm9="}) {  // bits that belong to no byte
    INFO(text);
    CHECK_FALSE(from_base64(text));
  }
}
