// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/rocks/shape_files.hpp"

#include "io/files/digest.hpp"
#include "io/mesh/mesh_file.hpp"

#include <filesystem>

namespace gyro {
namespace {

template <class Shapes>
RockShapes converted(const Shapes& shapes) {
  return shapes;
}

RockShapes converted(const ShapeFiles& files) {
  GivenShapes given{{}, files.corners};
  for (const std::string& path : files.paths) {
    // The path is a part of the content, because the notes contain it.
    given.shapes.push_back({std::filesystem::path(path).stem().string(), path + " " + digest_of(read_bytes(path)),
                            [path] { return read_solid(path); }});
  }
  return given;
}

}  // namespace

RockShapes recipe_shapes(const ShapeSource& source) {
  return std::visit([](const auto& shapes) { return converted(shapes); }, source);
}

}  // namespace gyro
