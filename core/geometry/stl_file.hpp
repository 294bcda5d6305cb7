// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace gyro {

/// A mesh and what was done to it on reading, one sentence each, for the log.
struct ReadMesh {
  TriangleMesh mesh;
  std::vector<std::string> notes;
};

/// Reads an STL (ASCII or binary) or OBJ file, told apart by the name's end. Vertices that coincide
/// within 1e-7 of the mesh's diagonal are welded; triangles without area and repeated triangles are
/// dropped and noted. Open meshes are fine. Coordinates stay in the file's unit.
/// @throws BadInput missing, unreadable, truncated or empty file; numbers that are not finite
ReadMesh read_mesh(const std::string& path);

/// Reads a mesh that must be one closed body, as a rock is, and repairs what scans suffer from, each with a note:
/// vertices up to 1e-4 of the diagonal apart are welded where that closes the surface, floating specks (below 1 % of
/// the volume) are dropped, triangles that run the wrong way round are turned so that all normals point outwards, holes
/// of up to 1 % of the surface are closed.
/// @throws BadInput as read_mesh; larger holes, edges of more than two triangles, several bodies, no volume
ReadMesh read_solid(const std::string& path);

/// "1 hole", "2 holes".
std::string count_of(Index n, const std::string& thing);

/// The parsers behind it, on the bytes of a file. @param name for messages
/// @throws BadInput
TriangleMesh parse_stl(std::string_view bytes, const std::string& name);
TriangleMesh parse_obj(std::string_view text, const std::string& name);

/// Writes binary STL (single precision). @throws OutputError
void write_stl(const std::string& path, const TriangleMesh& mesh);

/// All bytes of a regular file. @throws BadInput if it cannot be read
std::string read_bytes(const std::string& path);

}  // namespace gyro
