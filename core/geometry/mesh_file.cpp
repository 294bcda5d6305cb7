// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/geometry/mesh_repair.hpp"
#include "core/geometry/stl_file.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
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

std::string count_of(Index n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
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

ReadMesh read_mesh(const std::string& path) {
  const std::string end = lower_extension(path);
  if (end != ".stl" && end != ".obj") throw BadInput(path + ": unknown kind of mesh; accepted are .stl and .obj files");
  const std::string bytes = read_bytes(path);
  const TriangleMesh soup = end == ".stl" ? parse_stl(bytes, path) : parse_obj(bytes, path);

  constexpr double weld_fraction = 1e-7;  // single precision, in which STL files are written
  const Box box = bounding_box(soup);
  const double diagonal = norm(box.high - box.low);
  if (!std::isfinite(diagonal)) throw BadInput(path + ": coordinates beyond 1e150; accepted are numbers in metres");
  ReadMesh read{weld(soup, weld_fraction * diagonal), {}};
  const Dropped dropped = drop_useless_triangles(read.mesh);
  if (read.mesh.triangles.empty()) throw BadInput(path + ": no triangle has an area; accepted is a surface");
  if (dropped.flat > 0)
    read.notes.push_back(path + ": " + count_of(dropped.flat, "triangle") + " without area dropped");
  if (dropped.repeated > 0)
    read.notes.push_back(path + ": " + count_of(dropped.repeated, "repeated triangle") + " dropped");
  return read;
}

ReadMesh read_solid(const std::string& path) {
  ReadMesh read = read_mesh(path);
  const Index turned = turn_outwards(read.mesh);
  const EdgeCheck check = check_edges(read.mesh);
  const std::string accepted = "; a rock is one closed surface, so every edge has two triangles";
  if (check.open > 0)
    throw BadInput(path + ": the surface is open, with " + count_of(check.open, "open edge") + accepted);
  if (check.crowded > 0) {
    throw BadInput(path + ": " + count_of(check.crowded, "edge") + " with more than two triangles" + accepted);
  }
  if (check.contradictory > 0) throw BadInput(path + ": the surface has only one side" + accepted);
  if (check.bodies != 1) throw BadInput(path + ": " + std::to_string(check.bodies) + " separate bodies" + accepted);

  const Box box = bounding_box(read.mesh);
  const double diagonal = norm(box.high - box.low);
  if (!(mass_properties(read.mesh).volume > 1e-9 * diagonal * diagonal * diagonal)) {
    throw BadInput(path + ": the surface encloses no volume" + accepted);
  }
  if (turned > 0) read.notes.push_back(path + ": " + count_of(turned, "triangle") + " turned to face outwards");
  return read;
}

}  // namespace gyro
