// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are the description of an FMU, or bad input; and the archive of one, without running its code.
#include "core/base/errors.hpp"
#include "io/fmu/archive.hpp"
#include "io/fmu/model_description.hpp"
#include "tests/fuzz/input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gyro::InputFile input("drive.fmu");
  input.write(data, size);
  for (const bool archived : {false, true}) {
    try {
      if (archived)
        gyro::read_model_description(gyro::Archive(input.path()).read("modelDescription.xml"));
      else
        gyro::read_model_description({reinterpret_cast<const char*>(data), size});
    } catch (const gyro::BadInput&) {  // which says what is wrong with the file
    }
  }
  return 0;
}
