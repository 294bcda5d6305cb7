// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/solid.hpp"

#include <string>

namespace gyro {

/// Reads a mesh from an STL (ASCII or binary) or OBJ file; the ending of the name says which. Coordinates stay in the
/// file's unit. The repairs are those of repaired_surface, their notes begin with the path.
/// @throws BadInput if the file is missing, unreadable, truncated or empty, or holds numbers that are not finite
RepairedMesh read_mesh(const std::string& path);

/// Reads a mesh that must be one closed body, as a rock is, with the repairs of repaired_solid.
/// @throws BadInput as read_mesh and repaired_solid, with the path
RepairedMesh read_solid(const std::string& path);

/// All bytes of a regular file. @throws BadInput if it is none or cannot be read
std::string read_bytes(const std::string& path);

}  // namespace gyro
