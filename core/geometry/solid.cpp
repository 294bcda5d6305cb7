// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/solid.hpp"

#include "core/base/errors.hpp"
#include "core/geometry/edges.hpp"
#include "core/geometry/holes.hpp"
#include "core/geometry/mesh.hpp"
#include "core/geometry/mesh_repair.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace gyro {
namespace {

constexpr double single_precision = 1e-7;  // [diagonal]; STL files hold single precision
constexpr double weld_limit = 1e-4;        // [diagonal]
constexpr double speck_share = 0.01;       // of the largest body's volume
constexpr double hole_share = 0.01;        // of the surface
constexpr double min_volume = 1e-9;        // [diagonal^3]
const std::string rule = "; a rock must be one closed surface, so that every edge has two triangles";

/// "1 hole", "2 holes".
std::string count_of(Index n, const std::string& thing) {
  return std::to_string(n) + " " + thing + (n == 1 ? "" : "s");
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

double diagonal_of(const TriangleMesh& mesh) {
  const Box box = bounding_box(mesh);
  return norm(box.high - box.low);
}

/// Welds vertices at increasing distances, tenfold in each step, if that closes an open surface without edges of three
/// triangles.
void weld_gaps(RepairedMesh& repaired) {
  if (check_edges(repaired.mesh).open == 0) return;
  for (double distance = 1e-6; distance <= weld_limit * 1.01; distance *= 10) {
    TriangleMesh welded = weld(repaired.mesh, distance * diagonal_of(repaired.mesh));
    drop_useless_triangles(welded);
    if (welded.triangles.empty()) return;
    const EdgeCheck check = check_edges(welded);
    if (check.open + check.crowded > 0) continue;
    char note[100];
    std::snprintf(note, sizeof note, "vertices up to %.2g of the diagonal apart welded, which closes the surface",
                  distance);
    repaired.notes.push_back(note);
    repaired.mesh = std::move(welded);
    return;
  }
}

void close_small_holes(RepairedMesh& repaired) {
  const Index open = check_edges(repaired.mesh).open;
  if (open == 0) return;
  const double surface = surface_area(repaired.mesh);
  const ClosedHoles holes = close_holes(repaired.mesh, hole_share);
  const std::string problem = "the surface is open, with " + count_of(open, "open edge");
  if (holes.ambiguous) throw BadInput(problem + " whose holes touch each other" + rule);
  if (holes.too_large > 0) {
    throw BadInput(problem + " around a hole of " + percent(holes.too_large / surface) +
                   " of its area; holes of up to " + percent(hole_share) + " are closed" + rule);
  }
  repaired.notes.push_back(count_of(holes.closed, "hole") + " closed, the largest of " +
                           percent(holes.largest / surface) + " of the surface");
}

/// @throws BadInput with the first fault that remains
void require_solid(const TriangleMesh& mesh) {
  const EdgeCheck check = check_edges(mesh);
  if (check.crowded > 0) throw BadInput(count_of(check.crowded, "edge") + " with more than two triangles" + rule);
  if (check.contradictory > 0) throw BadInput("the surface has only one side" + rule);
  if (check.open > 0) throw BadInput("the surface is open, with " + count_of(check.open, "open edge") + rule);
  if (check.bodies != 1) throw BadInput(std::to_string(check.bodies) + " separate bodies" + rule);
  const double diagonal = diagonal_of(mesh);
  if (!(mass_properties(mesh).volume > min_volume * diagonal * diagonal * diagonal))
    throw BadInput("the surface encloses no volume" + rule);
}

}  // namespace

RepairedMesh repaired_surface(const TriangleMesh& given) {
  if (given.vertices.empty()) throw BadInput("no triangle has an area; the mesh must be a surface");
  const double diagonal = diagonal_of(given);
  if (!std::isfinite(diagonal)) throw BadInput("coordinates beyond 1e150; they must be in metres");
  RepairedMesh repaired{weld(given, single_precision * diagonal), {}};
  const Dropped dropped = drop_useless_triangles(repaired.mesh);
  if (repaired.mesh.triangles.empty()) throw BadInput("no triangle has an area; the mesh must be a surface");
  if (dropped.flat > 0) repaired.notes.push_back(count_of(dropped.flat, "triangle") + " without area dropped");
  if (dropped.repeated > 0) repaired.notes.push_back(count_of(dropped.repeated, "repeated triangle") + " dropped");
  return repaired;
}

RepairedMesh repaired_solid(const TriangleMesh& given) {
  RepairedMesh repaired = repaired_surface(given);
  weld_gaps(repaired);
  const Index specks = drop_specks(repaired.mesh, speck_share);
  if (specks > 0) {
    repaired.notes.push_back(count_of(specks, "floating speck") + " below " + percent(speck_share) +
                             " of the volume dropped");
  }
  Index flipped = orient_outwards(repaired.mesh);
  if (const EdgeCheck check = check_edges(repaired.mesh); check.crowded + check.contradictory == 0) {
    close_small_holes(repaired);
    if (mass_properties(repaired.mesh).volume < 0) {  // the volume of the open surface had the wrong sign
      flipped = static_cast<Index>(repaired.mesh.triangles.size()) - flipped;
      for (auto& t : repaired.mesh.triangles) std::swap(t.y, t.z);
    }
  }
  require_solid(repaired.mesh);
  if (flipped > 0) repaired.notes.push_back(count_of(flipped, "triangle") + " flipped to face outwards");
  return repaired;
}

}  // namespace gyro
