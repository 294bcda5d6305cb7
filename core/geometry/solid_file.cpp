// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/errors.hpp"
#include "core/geometry/holes.hpp"
#include "core/geometry/mesh_repair.hpp"
#include "core/geometry/stl_file.hpp"

#include <cstdio>

namespace gyro {
namespace {

constexpr double weld_limit = 1e-4;   // [diagonal]
constexpr double speck_share = 0.01;  // of the largest body's volume
constexpr double hole_share = 0.01;   // of the surface
constexpr double min_volume = 1e-9;   // [diagonal^3]
const std::string advice = "; a rock must be one closed surface, with two triangles at every edge";

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

double diagonal_of(const TriangleMesh& mesh) {
  const Box box = bounding_box(mesh);
  return norm(box.high - box.low);
}

/// Welds further apart, tenfold at a time, if that closes an open surface without making edges of three triangles.
void weld_gaps(ReadMesh& read, const std::string& path) {
  if (check_edges(read.mesh).open == 0) return;
  for (double distance = 1e-6; distance <= weld_limit * 1.01; distance *= 10) {
    TriangleMesh welded = weld(read.mesh, distance * diagonal_of(read.mesh));
    drop_useless_triangles(welded);
    if (welded.triangles.empty()) return;
    const EdgeCheck check = check_edges(welded);
    if (check.open + check.crowded > 0) continue;
    char note[100];
    std::snprintf(note, sizeof note, ": vertices up to %.2g of the diagonal apart welded, which closes the surface",
                  distance);
    read.notes.push_back(path + note);
    read.mesh = std::move(welded);
    return;
  }
}

void close_small_holes(ReadMesh& read, const std::string& path) {
  const Index open = check_edges(read.mesh).open;
  if (open == 0) return;
  const double surface = surface_area(read.mesh);
  const ClosedHoles holes = close_holes(read.mesh, hole_share);
  if (holes.ambiguous) {
    throw BadInput(path + ": the surface is open, with " + count_of(open, "open edge") +
                   " whose holes touch each other" + advice);
  }
  if (holes.too_large > 0) {
    throw BadInput(path + ": the surface is open, with " + count_of(open, "open edge") + " around a hole of " +
                   percent(holes.too_large / surface) + " of its area; holes of up to " + percent(hole_share) +
                   " are closed" + advice);
  }
  read.notes.push_back(path + ": " + count_of(holes.closed, "hole") + " closed, the largest of " +
                       percent(holes.largest / surface) + " of the surface");
}

/// @throws BadInput with what is wrong for good
void require_solid(const TriangleMesh& mesh, const std::string& path) {
  const EdgeCheck check = check_edges(mesh);
  if (check.crowded > 0) {
    throw BadInput(path + ": " + count_of(check.crowded, "edge") + " with more than two triangles" + advice);
  }
  if (check.contradictory > 0) throw BadInput(path + ": the surface has only one side" + advice);
  if (check.open > 0)
    throw BadInput(path + ": the surface is open, with " + count_of(check.open, "open edge") + advice);
  if (check.bodies != 1) throw BadInput(path + ": " + std::to_string(check.bodies) + " separate bodies" + advice);
  const double diagonal = diagonal_of(mesh);
  if (!(mass_properties(mesh).volume > min_volume * diagonal * diagonal * diagonal))
    throw BadInput(path + ": the surface encloses no volume" + advice);
}

}  // namespace

ReadMesh read_solid(const std::string& path) {
  ReadMesh read = read_mesh(path);
  weld_gaps(read, path);
  const Index specks = drop_specks(read.mesh, speck_share);
  if (specks > 0) {
    read.notes.push_back(path + ": " + count_of(specks, "floating speck") + " below " + percent(speck_share) +
                         " of the volume dropped");
  }
  Index turned = turn_outwards(read.mesh);
  if (const EdgeCheck check = check_edges(read.mesh); check.crowded + check.contradictory == 0) {
    close_small_holes(read, path);
    if (mass_properties(read.mesh).volume < 0) {  // the open surface misled about its side
      turned = static_cast<Index>(read.mesh.triangles.size()) - turned;
      for (auto& t : read.mesh.triangles) std::swap(t.y, t.z);
    }
  }
  require_solid(read.mesh, path);
  if (turned > 0) read.notes.push_back(path + ": " + count_of(turned, "triangle") + " turned to face outwards");
  return read;
}

}  // namespace gyro
