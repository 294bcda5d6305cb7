// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// Closed meshes in files, STL or OBJ.
struct ShapeFiles {
  std::vector<std::string> paths;
  int corners = 0;  ///< of the polyhedron that replaces a scan; 0: the scan itself
};

/// Where a case takes the shapes of its rocks from.
using ShapeSource = std::variant<ProceduralShapes, ShapeFiles, CylinderSpecimen>;

/// The shapes as a recipe takes them. Of each file the digest is taken now; its mesh is read when the library is made.
/// @throws BadInput if a file cannot be read
RockShapes recipe_shapes(const ShapeSource& source);

}  // namespace gyro
