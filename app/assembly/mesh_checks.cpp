// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/mesh_checks.hpp"

#include "app/assembly/in_mm.hpp"
#include "core/base/errors.hpp"
#include "io/schema/schema.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gyro {
namespace {

constexpr double suspicious = 100;     // [m]
constexpr double shortest = 1e-5;      // [m]; no wall is smaller
constexpr double many_rocks = 1000;    // extent / largest rock; above it, a drawing in mm is more likely
constexpr double round_within = 0.02;  // a polygon of 12 sides is 1.7 % off a circle

bool equal(double a, double b) {
  return std::abs(a - b) <= round_within * std::max(std::abs(a), std::abs(b));
}

/// Diameter or height, whichever is larger [m].
double extent_of(const ProfileShape& profile) {
  double low = profile.points.front().z, high = low, diameter = 0;
  for (const ProfilePoint& p : profile.points) {
    low = std::min(low, p.z), high = std::max(high, p.z);
    diameter = std::max(diameter, 2 * p.r);
  }
  return std::max(diameter, high - low);
}

std::string scale_advice(const std::string& wall) {
  return "; meshes are in metres: for a drawing in mm, set walls." + wall + ".scale: 0.001";
}

}  // namespace

std::string name_of(const CaseWall& wall, const MeshFile& file) {
  return "wall " + wall.name + ": " + file.path.string() + ": ";
}

void check_extent(const TriangleMesh& mesh, const MeshFile& file) {
  const Extents extents = extents_of(mesh);
  if (!(extents.largest() <= longest_length))
    throw BadInput(file.path.string() + ": the mesh is larger than 1 km (" + to_string(extents) +
                   "); meshes are in metres: set the wall's scale, which is 0.001 for a drawing in mm");
  if (!(extents.largest() >= shortest))
    throw BadInput(file.path.string() + ": the mesh is smaller than 0.01 mm (" + in_mm(extents.largest()) +
                   "); meshes are in metres: check the wall's scale, or leave it out");
}

std::vector<std::string> frame_notes(const CaseWall& wall, const MeshFile& file, const TriangleMesh& liner) {
  const Extents extents = extents_of(liner);
  const Vec3d size = extents.size(), middle = extents.middle();
  const std::string begin = name_of(wall, file), keys = "walls." + wall.name + ".";
  const auto upright_at = [&](double width, double depth, double a, double b) {
    return equal(width, depth) && std::hypot(a, b) <= round_within * std::max(width, depth);
  };
  if (!equal(size.x, size.y) && upright_at(size.x, size.z, middle.x, middle.z))
    return {begin + "its axis seems to be y, but the machine's axis is z: set " + keys + "rotate: [90 deg, 0, 0]"};
  if (!equal(size.x, size.y) && upright_at(size.y, size.z, middle.y, middle.z))
    return {begin + "its axis seems to be x, but the machine's axis is z: set " + keys + "rotate: [0, -90 deg, 0]"};
  if (std::hypot(middle.x, middle.y) > round_within * std::max(size.x, size.y))
    return {begin + "its middle is at x = " + in_mm(middle.x) + ", y = " + in_mm(middle.y) +
            "; the machine's axis is at x = y = 0: set " + keys + "shift"};
  return {};
}

std::vector<std::string> setting_notes(const MeshSetting& setting, const GyrationMotion& motion, double height) {
  std::vector<std::string> notes;
  if (std::abs(motion.lift) > 0.1 * height)
    notes.push_back("the mantle is moved by more than a tenth of the concave's height, " + in_mm(height) +
                    "; check unit and position of both meshes (scale, shift)");
  const double travel = 2 * motion.eccentricity, opens = setting.open - setting.closed;
  if (std::abs(opens - travel) > 0.5 * travel)
    notes.push_back("open less closed side setting is " + in_mm(opens) + ", but the throw is " + in_mm(travel) +
                    "; check axis and position of both meshes (rotate, shift)");
  return notes;
}

std::vector<std::string> size_notes(const Case& input, const std::vector<Wall>& walls, double rock) {
  std::vector<std::string> notes;
  for (std::size_t k = 0; k < input.walls.size(); ++k) {  // not the lid, which the program makes
    const auto* mesh = std::get_if<TriangleMesh>(&walls[k].shape);
    const auto* file = std::get_if<MeshFile>(&input.walls[k].shape);
    const auto* profile = std::get_if<ProfileShape>(&walls[k].shape);
    if ((mesh == nullptr || file == nullptr) && profile == nullptr) continue;
    const double extent = profile != nullptr ? extent_of(*profile) : extents_of(*mesh).largest();
    char text[100];
    if (rock > 0 && extent > many_rocks * rock)
      std::snprintf(text, sizeof text, "%.3g m long, %.3g times the largest rock", extent, extent / rock);
    else if (extent > suspicious)
      std::snprintf(text, sizeof text, "%.3g m long", extent);
    else
      continue;
    notes.push_back(profile != nullptr ? "wall " + walls[k].name + ": " + input.crusher->profile.string() + ": " +
                                             text + "; profiles are in metres: divide numbers in mm by 1000"
                                       : name_of(input.walls[k], *file) + text + scale_advice(walls[k].name));
  }
  return notes;
}

}  // namespace gyro
