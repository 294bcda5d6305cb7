// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/files/read_file.hpp"
#include "tests/catch.hpp"
#include "tests/io/mesh/written.hpp"

#include <sys/stat.h>
#include <fstream>
#include <thread>

using namespace gyro;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

TEST_CASE("A device is refused as a file") {
  CHECK_THROWS_WITH(read_file("/dev/zero"), Catch::Matchers::Contains("is a device"));
}

TEST_CASE("A file is read as a whole, whatever its bytes") {
  const ScratchDirectory folder;
  std::string bytes = "a\r\n";
  bytes.resize(3 << 20, '\0');
  bytes += "end";
  CHECK((read_file(written(folder, "large", bytes)) == bytes));
  CHECK(read_file(written(folder, "empty", "")).empty());
  CHECK(read_file(written(folder, "four", "1234"), 4) == "1234");
  CHECK(!read_file("/proc/self/status").empty());  // the system reports a size of 0 for it
}

TEST_CASE("A file that cannot be read is refused with the reason") {
  const ScratchDirectory folder;
  CHECK_THROWS_WITH(read_file(folder.path() / "none"), EndsWith("none: no such file; check the path"));
  CHECK_THROWS_WITH(read_file(folder.path()), Contains("is a directory"));
  CHECK_THROWS_WITH(read_file(written(folder, "five", "12345"), 4), Contains("is larger than 0 MB"));
  CHECK_THROWS_WITH(read_file("/proc/self/mem"), Contains("/proc/self/mem: cannot be read: Input/output error"));
  try {
    read_file("/proc/self/mem");
  } catch (const UnreadableFile& unreadable) {
    CHECK_THAT(unreadable.problem, Catch::Matchers::StartsWith("cannot be read"));
  }
}

TEST_CASE("A pipe is read while somebody writes into it") {
  const ScratchDirectory folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  const std::string bytes(300'000, 'x');  // more than a pipe holds
  std::thread writer([&] { std::ofstream(pipe) << bytes; });
  const std::string read = read_file(pipe);
  writer.join();
  CHECK((read == bytes));
}
