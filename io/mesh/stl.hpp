// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <string>
#include <string_view>

namespace gyro {

/// Reads the bytes of an STL file, ASCII or binary. Every triangle has three vertices of its own. The size decides
/// whether a file is binary, not its first word, and the triangle count must agree with it.
/// @param name for messages
/// @throws BadInput if the bytes are truncated or damaged, hold no triangle or numbers that are not finite
TriangleMesh parse_stl(std::string_view bytes, const std::string& name);

/// Writes binary STL (single precision). @throws OutputError
void write_stl(const std::string& path, const TriangleMesh& mesh);

}  // namespace gyro
