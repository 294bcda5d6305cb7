// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// Reads the vertices and faces of the text of an OBJ file; polygons become fans of triangles. Everything else
/// (textures, normals, groups, materials, lines) is skipped.
/// @param name   for messages, which add the line
/// @param notes  receives signs that the file was cut off; may be null
/// @throws BadInput if a line is malformed, or there is no face
TriangleMesh parse_obj(std::string_view text, const std::string& name, std::vector<std::string>* notes = nullptr);

}  // namespace gyro
