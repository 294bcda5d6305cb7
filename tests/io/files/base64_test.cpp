// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/base64.hpp"

#include "tests/catch.hpp"

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
