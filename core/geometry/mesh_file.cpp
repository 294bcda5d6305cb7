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

}  // namespace

std::string count_of(Index n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

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
  if (end != ".stl" && end != ".obj") throw BadInput(path + ": unknown kind of mesh; use an .stl or .obj file");
  const std::string bytes = read_bytes(path);
  const TriangleMesh soup = end == ".stl" ? parse_stl(bytes, path) : parse_obj(bytes, path);

  constexpr double weld_fraction = 1e-7;  // single precision, in which STL files are written
  const Box box = bounding_box(soup);
  const double diagonal = norm(box.high - box.low);
  if (!std::isfinite(diagonal)) throw BadInput(path + ": coordinates beyond 1e150; give coordinates in metres");
  ReadMesh read{weld(soup, weld_fraction * diagonal), {}};
  const Dropped dropped = drop_useless_triangles(read.mesh);
  if (read.mesh.triangles.empty()) throw BadInput(path + ": no triangle has an area; give a surface");
  if (dropped.flat > 0)
    read.notes.push_back(path + ": " + count_of(dropped.flat, "triangle") + " without area dropped");
  if (dropped.repeated > 0)
    read.notes.push_back(path + ": " + count_of(dropped.repeated, "repeated triangle") + " dropped");
  return read;
}

}  // namespace gyro
