// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/holes.hpp"

#include "core/geometry/edges.hpp"
#include "core/geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace gyro {
namespace {

/// The rim of a hole: its vertices in the direction of the triangles that close it.
using Rim = std::vector<Index>;

/// Next vertex along the rims, by vertex. None if two rims share a vertex.
std::optional<std::map<Index, Index>> rim_steps(const TriangleMesh& mesh) {
  std::map<Edge, int> uses;  // directed edges
  for (const auto& t : mesh.triangles) {
    for (const Edge& e : edges_of(t)) ++uses[e];
  }
  std::map<Index, Index> next;
  for (const auto& [edge, count] : uses) {
    if (uses.contains({edge.second, edge.first})) continue;
    if (!next.emplace(edge.second, edge.first).second) return std::nullopt;  // against the triangle's direction
  }
  return next;
}

/// Rims of all holes; every open edge belongs to one rim.
std::vector<Rim> trace_rims(std::map<Index, Index> next) {
  std::vector<Rim> rims;
  while (!next.empty()) {
    Rim rim;
    Index at = next.begin()->first;
    for (auto step = next.find(at); step != next.end(); step = next.find(at)) {
      rim.push_back(at);
      at = step->second;
      next.erase(step);
    }
    rims.push_back(std::move(rim));
  }
  return rims;
}

Vec3d centre_of(const TriangleMesh& mesh, const Rim& rim) {
  Vec3d sum{0, 0, 0};
  for (const Index v : rim) sum += mesh.vertices[v];
  return (1 / static_cast<double>(rim.size())) * sum;
}

double fan_area(const TriangleMesh& mesh, const Rim& rim, const Vec3d& centre) {
  double area = 0;
  for (std::size_t k = 0; k < rim.size(); ++k)
    area += triangle_area(centre, mesh.vertices[rim[k]], mesh.vertices[rim[(k + 1) % rim.size()]]);
  return area;
}

void add_fan(TriangleMesh& mesh, const Rim& rim, const Vec3d& centre) {
  if (rim.size() == 3) {
    mesh.triangles.push_back({rim[0], rim[1], rim[2]});
    return;
  }
  const Index hub = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.push_back(centre);
  for (std::size_t k = 0; k < rim.size(); ++k) mesh.triangles.push_back({hub, rim[k], rim[(k + 1) % rim.size()]});
}

}  // namespace

ClosedHoles close_holes(TriangleMesh& mesh, double max_share) {
  ClosedHoles result;
  const auto next = rim_steps(mesh);
  if (!next) {
    result.ambiguous = true;
    return result;
  }
  const double allowed = max_share * surface_area(mesh);
  for (const Rim& rim : trace_rims(*next)) {
    const Vec3d centre = centre_of(mesh, rim);
    const double area = fan_area(mesh, rim, centre);
    if (area > allowed) {
      result.too_large = result.too_large > 0 ? std::min(result.too_large, area) : area;
      continue;
    }
    add_fan(mesh, rim, centre);
    ++result.closed;
    result.largest = std::max(result.largest, area);
  }
  return result;
}

}  // namespace gyro
