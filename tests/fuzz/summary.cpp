// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a summary, or bad input.
#include "io/run/summary.hpp"
#include "core/base/errors.hpp"
#include "tests/fuzz/input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gyro::InputFile input("summary.json");
  input.write(data, size);
  try {
    gyro::to_text(gyro::load_summary(input.folder()), input.folder());
  } catch (const gyro::BadInput&) {  // which says what is wrong with the file
  }
  return 0;
}
