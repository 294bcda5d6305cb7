// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a case, or have problems with their places; nothing is thrown.
#include "io/case/case.hpp"
#include "tests/fuzz/input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gyro::InputFile input("case.yaml");
  input.write(data, size);
  gyro::load_case(input.path());
  return 0;
}
