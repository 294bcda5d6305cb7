// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a snapshot, or bad input.
#include "core/base/errors.hpp"
#include "io/run/poly_data.hpp"
#include "tests/fuzz/input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gyro::InputFile input("particles.vtp");
  input.write(data, size);
  try {
    gyro::read_vtp(input.path());
  } catch (const gyro::BadInput&) {  // which says what is wrong with the file
  }
  return 0;
}
