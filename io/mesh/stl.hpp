// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// Reads the bytes of an STL file, ASCII or binary. Every triangle gets three vertices of its own. The size decides
/// whether a file is binary, not its first word, and the triangle count must agree with the size. ASCII files may
/// contain several solids, words in any case, a byte-order mark, and comments in lines that begin with # or ;.
/// @param name   for messages
/// @param notes  null, or receives a note on what was ignored: a few bytes after the last triangle of a binary file
/// @throws BadInput if the bytes are truncated or damaged, hold no triangle or numbers that are not finite
TriangleMesh parse_stl(std::string_view bytes, const std::string& name, std::vector<std::string>* notes = nullptr);

/// Writes binary STL (single precision). @throws OutputError
void write_stl(const std::string& path, const TriangleMesh& mesh);

}  // namespace gyro
