// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes are a mesh, or bad input: STL, binary or text, and OBJ.
#include "core/base/errors.hpp"
#include "io/mesh/mesh_file.hpp"
#include "tests/fuzz/input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const gyro::InputFile input("mesh.stl");
  input.write(data, size);
  static const gyro::InputFile other("mesh.obj");
  other.write(data, size);
  for (const std::filesystem::path& path : {input.path(), other.path()}) {
    try {
      gyro::read_solid(path);
    } catch (const gyro::BadInput&) {  // which says what is wrong with the file
    }
  }
  return 0;
}
