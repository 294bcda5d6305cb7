// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/solid.hpp"

#include <string>

namespace gyro {

/// Reads a mesh from an STL (ASCII or binary) or OBJ file; the extension of its name decides which. Coordinates stay in
/// the file's unit. The mesh is repaired by repaired_surface; the notes begin with the path.
/// @throws BadInput if the file is missing, unreadable, truncated or empty, or holds numbers that are not finite
RepairedMesh read_mesh(const std::string& path);

/// Reads a mesh that must be one closed body, such as a rock, and repairs it by repaired_solid.
/// @throws BadInput, with the path, for the reasons of read_mesh and repaired_solid
RepairedMesh read_solid(const std::string& path);

/// All bytes of a regular file. @throws BadInput if it is not a regular file or cannot be read
std::string read_bytes(const std::string& path);

}  // namespace gyro
