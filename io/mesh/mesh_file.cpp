// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/mesh/mesh_file.hpp"

#include "core/base/errors.hpp"
#include "io/files/read_file.hpp"
#include "io/mesh/obj.hpp"
#include "io/mesh/stl.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace gyro {
namespace {

std::string lower_extension(const std::string& path) {
  std::string end = std::filesystem::path(path).extension().string();
  std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
  return end;
}

/// Refuses meshes so small that their areas and volumes would be zero.
void check_coordinates(const TriangleMesh& mesh, const std::string& path) {
  constexpr double smallest = 1e-30;
  const Vec3d& first = mesh.vertices.front();
  double extent = 0;
  for (const Vec3d& v : mesh.vertices)
    extent = std::max({extent, std::abs(v.x - first.x), std::abs(v.y - first.y), std::abs(v.z - first.z)});
  if (extent < smallest)
    throw BadInput(path + ": its coordinates differ by less than 1e-30; check the unit, or export the mesh again");
}

/// The triangles of a file without repairs, and notes on its form.
RepairedMesh parse_file(const std::string& path) {
  const std::string end = lower_extension(path);
  if (end != ".stl" && end != ".obj")
    throw BadInput(path + ": unknown kind of mesh; only .stl and .obj files are read");
  const std::string bytes = read_bytes(path);
  RepairedMesh given;
  given.mesh = end == ".stl" ? parse_stl(bytes, path, &given.notes) : parse_obj(bytes, path, &given.notes);
  check_coordinates(given.mesh, path);
  return given;
}

/// Reads a file and repairs its mesh. Notes and errors of the repair name the file.
RepairedMesh read_repaired(const std::string& path, RepairedMesh (*repair)(const TriangleMesh&)) {
  const RepairedMesh given = parse_file(path);
  try {
    RepairedMesh repaired = repair(given.mesh);
    repaired.notes.insert(repaired.notes.begin(), given.notes.begin(), given.notes.end());
    for (std::string& note : repaired.notes) note.insert(0, path + ": ");
    return repaired;
  } catch (const BadInput& problem) {
    throw BadInput(path + ": " + problem.what());
  }
}

}  // namespace

std::string read_bytes(const std::string& path) {
  // A pipe can be read only once, but meshes are read twice.
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw BadInput(path + ": is not a regular file; give an STL or OBJ file");
  return read_file(path);
}

RepairedMesh read_mesh(const std::string& path) {
  return read_repaired(path, repaired_surface);
}

RepairedMesh read_solid(const std::string& path) {
  return read_repaired(path, repaired_solid);
}

}  // namespace gyro
