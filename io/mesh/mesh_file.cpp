// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh/mesh_file.hpp"

#include "core/base/errors.hpp"
#include "io/mesh/obj.hpp"
#include "io/mesh/stl.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace gyro {
namespace {

std::string lower_extension(const std::string& path) {
  std::string end = std::filesystem::path(path).extension().string();
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  return end;
}

/// The triangles as the file has them.
TriangleMesh parse_file(const std::string& path) {
  const std::string end = lower_extension(path);
  if (end != ".stl" && end != ".obj")
    throw BadInput(path + ": unknown kind of mesh; only .stl and .obj files are read");
  const std::string bytes = read_bytes(path);
  return end == ".stl" ? parse_stl(bytes, path) : parse_obj(bytes, path);
}

/// Reads a file and repairs its mesh; notes and errors of the repair name the file.
RepairedMesh read_repaired(const std::string& path, RepairedMesh (*repair)(const TriangleMesh&)) {
  const TriangleMesh given = parse_file(path);
  try {
    RepairedMesh repaired = repair(given);
    for (std::string& note : repaired.notes) note.insert(0, path + ": ");
    return repaired;
  } catch (const BadInput& problem) {
    throw BadInput(path + ": " + problem.what());
  }
}

}  // namespace

std::string read_bytes(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw BadInput(path + ": no such file");
  if (!std::filesystem::is_regular_file(path, error)) throw BadInput(path + ": not a file");
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  const bool empty = std::filesystem::file_size(path, error) == 0;
  if (!file || (!empty && !(bytes << file.rdbuf()))) throw BadInput(path + ": cannot be read");
  return std::move(bytes).str();
}

RepairedMesh read_mesh(const std::string& path) {
  return read_repaired(path, repaired_surface);
}

RepairedMesh read_solid(const std::string& path) {
  return read_repaired(path, repaired_solid);
}

}  // namespace gyro
