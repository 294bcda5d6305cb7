// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a table, or have problems with their places; nothing is thrown.
#include "io/case/csv.hpp"
#include "tests/fuzz/input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gyro::InputFile input("table.csv");
  input.write(data, size);
  gyro::read_csv(input.path(), {"id", "x", "y"}, {{"vx", "vy"}, {"rock"}});
  return 0;
}
