// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/walls.hpp"

#include "app/assembly/bad_key.hpp"
#include "app/assembly/lid.hpp"
#include "app/assembly/mesh_checks.hpp"
#include "core/walls/radial_sections.hpp"
#include "io/mesh/mesh_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gyro {
namespace {

constexpr int picture_sectors = 240;

TriangleMesh plane_picture(const PlaneShape& plane, double half) {
  const Vec3d helper = std::abs(plane.normal.z) < 0.9 ? Vec3d{0, 0, 1} : Vec3d{1, 0, 0};
  const Vec3d a0 = cross(plane.normal, helper);
  const Vec3d a = (half / norm(a0)) * a0, b = cross(plane.normal, a);
  return {{plane.point - a - b, plane.point + a - b, plane.point + a + b, plane.point - a + b}, {{0, 1, 2}, {0, 2, 3}}};
}

bool gyrates(const Wall& wall) {
  return std::holds_alternative<GyrationMotion>(wall.motion);
}

void add_wall(CaseWalls& out, const CaseWall& wall) {
  Wall made;
  made.name = wall.name;
  made.motion = wall.motion;
  made.material = wall.material;
  const Index number = static_cast<Index>(out.walls.size());
  if (const auto* plane = std::get_if<PlaneShape>(&wall.shape)) {
    made.shape = *plane;
    out.pictures.push_back({plane_picture(*plane, 0.5), number});
  } else if (const auto* file = std::get_if<MeshFile>(&wall.shape)) {
    RepairedMesh read = read_mesh(file->path.string());
    for (const std::string& note : read.notes) out.notes.push_back("wall " + wall.name + ": " + note);
    read.mesh = framed(std::move(read.mesh), file->frame);
    check_extent(read.mesh, *file);
    out.notes.push_back(name_of(wall, *file) + to_string(extents_of(read.mesh)));
    if (wall.name == "concave" || gyrates(made))
      for (std::string& note : frame_notes(wall, *file, read.mesh)) out.doubts.push_back(std::move(note));
    out.pictures.push_back({read.mesh, number});
    made.shape = std::move(read.mesh);
  } else {
    const bool mantle = std::get<ProfileLiner>(wall.shape).mantle;
    const ProfileShape& shape = mantle ? out.liners->mantle : out.liners->concave;
    made.shape = shape;
    if (std::holds_alternative<GyrationMotion>(made.motion)) made.motion = out.liners->motion;
    out.pictures.push_back({revolve(shape, picture_sectors), number});
  }
  out.walls.push_back(std::move(made));
}

/// Lifts gyrating meshes so that the closed side setting is met.
void set_meshes(CaseWalls& out, double closed_side_setting) {
  if (out.liners || std::ranges::none_of(out.walls, gyrates)) return;
  const std::optional<MeshLiners> liners = mesh_liners(out.walls);
  if (!liners) {
    out.notes.push_back(
        "no fixed mesh is called concave: closed_side_setting is not imposed, the mantle stays as drawn");
    return;
  }
  const MeshGap gap(liners->mantle, liners->concave, liners->motion);
  const double lift = gap.solve_lift(closed_side_setting);
  for (Wall& wall : out.walls)
    if (auto* motion = std::get_if<GyrationMotion>(&wall.motion)) motion->lift = lift;
  const MeshSetting setting = gap.measure(lift);
  char note[160];
  std::snprintf(note, sizeof note, "mantle lifted by %.2f mm: closed side setting %.2f mm, open %.2f mm", lift * 1e3,
                setting.closed * 1e3, setting.open * 1e3);
  out.notes.push_back(note);
  GyrationMotion lifted = liners->motion;
  lifted.lift = lift;
  for (std::string& doubt : setting_notes(setting, lifted, extents_of(liners->concave).high.z))
    out.doubts.push_back(std::move(doubt));
}

/// The same; the error message includes the doubts about the meshes.
void set_doubtful_meshes(CaseWalls& out, double closed_side_setting) {
  try {
    set_meshes(out, closed_side_setting);
  } catch (const BadInput& problem) {
    std::string message = problem.what();
    for (const std::string& doubt : out.doubts) message += " (" + doubt + ")";
    throw BadInput(message);
  }
}

void add_lid(CaseWalls& out, double height) {
  out.walls.push_back(make_lid(height, out.walls));
  const auto& shape = std::get<ProfileShape>(out.walls.back().shape);
  out.pictures.push_back({revolve(shape, picture_sectors), static_cast<Index>(out.walls.size()) - 1});
}

ConcaveOutline outline_of(const TriangleMesh& mesh) {
  HeightRange heights{1e300, -1e300};
  for (const Vec3d& v : mesh.vertices) heights = {std::min(heights.low, v.z), std::max(heights.high, v.z)};
  const RadialSections sections(mesh, 0, heights, RadialSections::Face::innermost);
  std::vector<ProfilePoint> points;
  for (int k = 0; k < RadialSections::levels; ++k) {
    points.push_back({0, sections.level(k)});
    for (int a = 0; a < RadialSections::azimuths; ++a)
      points.back().r = std::max(points.back().r, sections.at(a, points.back().z));
  }
  return ConcaveOutline(std::move(points));
}

}  // namespace

std::optional<ConcaveOutline> concave_outline(std::span<const Wall> walls) {
  for (const Wall& wall : walls) {
    if (wall.name != "concave" || !std::holds_alternative<Fixed>(wall.motion)) continue;
    if (const auto* profile = std::get_if<ProfileShape>(&wall.shape)) return ConcaveOutline(profile->points);
    if (const auto* mesh = std::get_if<TriangleMesh>(&wall.shape)) return outline_of(*mesh);
  }
  return std::nullopt;
}

Liners liners_of(const CaseCrusher& crusher) {
  return make_liners(crusher.liners, {crusher.closed_side_setting, crusher.eccentricity, crusher.pivot_height});
}

std::optional<MeshLiners> mesh_liners(std::span<const Wall> walls) {
  const TriangleMesh *concave = nullptr, *mantle = nullptr;
  const GyrationMotion* motion = nullptr;
  for (const Wall& wall : walls) {
    const auto* shape = std::get_if<TriangleMesh>(&wall.shape);
    if (wall.name == "concave" && std::holds_alternative<Fixed>(wall.motion)) concave = shape;
    if (motion != nullptr) continue;
    motion = std::get_if<GyrationMotion>(&wall.motion);
    mantle = motion != nullptr ? shape : nullptr;
  }
  if (concave == nullptr || mantle == nullptr) return std::nullopt;
  return MeshLiners{*concave, *mantle, *motion};
}

CaseWalls make_walls(const Case& input) {
  CaseWalls out;
  if (input.crusher && !input.crusher->liners.empty())
    out.liners = blaming("crusher", [&] { return liners_of(*input.crusher); });
  for (const CaseWall& wall : input.walls) blaming("walls." + wall.name, [&] { add_wall(out, wall); });
  if (input.crusher) blaming("crusher", [&] { set_doubtful_meshes(out, input.crusher->closed_side_setting); });
  if (input.crusher && input.crusher->lid) blaming("crusher.lid", [&] { add_lid(out, *input.crusher->lid); });
  out.notes.insert(out.notes.end(), out.doubts.begin(), out.doubts.end());
  return out;
}

}  // namespace gyro
