// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/library_wait.hpp"

#include "tests/catch.hpp"

#include <sstream>

using namespace gyro;

TEST_CASE("check says how far the library is when it takes more than two seconds, and then every ten") {
  LibraryWait::Clock::time_point now{};
  std::ostringstream out;
  const LibraryWait wait([&] { return now; }, out);
  const auto said = [&](double seconds, int made) {
    now = LibraryWait::Clock::time_point(std::chrono::milliseconds(static_cast<int>(1e3 * seconds)));
    out.str("");
    wait(made, 100);
    return out.str();
  };
  CHECK(said(1.9, 1).empty());
  CHECK(said(2, 2) == "library: 2 of 100 rocks made, less than 1 min 38 s left\n");
  CHECK(said(3, 1).empty());  // another thread was faster
  CHECK(said(11.9, 3).empty());
  CHECK(said(12, 4) == "library: 4 of 100 rocks made, less than 4 min 48 s left\n");
  CHECK(said(30, 100).empty());  // complete
}
