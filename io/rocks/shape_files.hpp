// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// Closed meshes in STL or OBJ files.
struct ShapeFiles {
  std::vector<std::string> paths;
  int corners = 0;  ///< largest number of corners of the polyhedron that replaces a scan; 0: the scan itself is used
};

/// The source of the shapes of a case's rocks.
using ShapeSource = std::variant<ProceduralShapes, ShapeFiles, CylinderSpecimen>;

/// The shapes for a recipe. The digest of each file is computed now; its mesh is read when the library is made.
/// @throws BadInput if a file cannot be read
RockShapes recipe_shapes(const ShapeSource& source);

}  // namespace gyro
