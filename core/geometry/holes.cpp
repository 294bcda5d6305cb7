// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/holes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace gyro {
namespace {

using Edge = std::pair<Index, Index>;

double triangle_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return norm(cross(b - a, c - a)) / 2;
}

/// The rim of a hole: its vertices in the order in which closing triangles run along it.
using Rim = std::vector<Index>;

/// Next vertex along the rims, by vertex. None if two rims share a vertex.
std::optional<std::map<Index, Index>> rim_steps(const TriangleMesh& mesh) {
  std::map<Edge, int> uses;  // directed edges
  for (const auto& t : mesh.triangles) {
    for (const Edge& e : {Edge{t.x, t.y}, Edge{t.y, t.z}, Edge{t.z, t.x}}) ++uses[e];
  }
  std::map<Index, Index> next;
  for (const auto& [edge, count] : uses) {
    if (uses.contains({edge.second, edge.first})) continue;
    if (!next.emplace(edge.second, edge.first).second) return std::nullopt;  // against the triangle's direction
  }
  return next;
}

/// Rims of all holes; every step belongs to one rim.
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

Vec3d middle_of(const TriangleMesh& mesh, const Rim& rim) {
  Vec3d sum{0, 0, 0};
  for (const Index v : rim) sum += mesh.vertices[v];
  return (1 / static_cast<double>(rim.size())) * sum;
}

double fan_area(const TriangleMesh& mesh, const Rim& rim, const Vec3d& middle) {
  double area = 0;
  for (std::size_t k = 0; k < rim.size(); ++k)
    area += triangle_area(middle, mesh.vertices[rim[k]], mesh.vertices[rim[(k + 1) % rim.size()]]);
  return area;
}

void add_fan(TriangleMesh& mesh, const Rim& rim, const Vec3d& middle) {
  if (rim.size() == 3) {
    mesh.triangles.push_back({rim[0], rim[1], rim[2]});
    return;
  }
  const Index centre = static_cast<Index>(mesh.vertices.size());
  mesh.vertices.push_back(middle);
  for (std::size_t k = 0; k < rim.size(); ++k) mesh.triangles.push_back({centre, rim[k], rim[(k + 1) % rim.size()]});
}

/// Number of the body of every triangle.
std::vector<Index> bodies_of(const TriangleMesh& mesh) {
  std::vector<Index> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::map<Edge, Index> first_user;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const auto& v = mesh.triangles[t];
    for (const auto& [a, b] : {Edge{v.x, v.y}, Edge{v.y, v.z}, Edge{v.z, v.x}}) {
      const Index other = root(first_user.try_emplace(std::minmax(a, b), t).first->second);
      parent[std::max(root(t), other)] = std::min(root(t), other);
    }
  }
  for (Index t = 0; t < static_cast<Index>(parent.size()); ++t) parent[t] = root(t);
  return parent;
}

}  // namespace

double surface_area(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += triangle_area(mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]);
  return area;
}

ClosedHoles close_holes(TriangleMesh& mesh, double largest_share) {
  ClosedHoles result;
  const auto next = rim_steps(mesh);
  if (!next) {
    result.ambiguous = true;
    return result;
  }
  const double allowed = largest_share * surface_area(mesh);
  for (const Rim& rim : trace_rims(*next)) {
    const Vec3d middle = middle_of(mesh, rim);
    const double area = fan_area(mesh, rim, middle);
    if (area > allowed) {
      result.too_large = result.too_large > 0 ? std::min(result.too_large, area) : area;
      continue;
    }
    add_fan(mesh, rim, middle);
    ++result.closed;
    result.largest = std::max(result.largest, area);
  }
  return result;
}

Index drop_specks(TriangleMesh& mesh, double share) {
  const std::vector<Index> body = bodies_of(mesh);
  std::map<Index, std::vector<Vec3<Index>>> parts;
  for (std::size_t t = 0; t < body.size(); ++t) parts[body[t]].push_back(mesh.triangles[t]);
  if (parts.size() < 2) return 0;
  TriangleMesh part{mesh.vertices, {}};
  std::map<Index, double> volume;
  double largest = 0;
  for (auto& [number, triangles] : parts) {
    part.triangles = std::move(triangles);
    volume[number] = std::abs(mass_properties(part).volume);
    largest = std::max(largest, volume[number]);
  }
  std::vector<Vec3<Index>> kept;
  for (std::size_t t = 0; t < body.size(); ++t) {
    if (volume[body[t]] >= share * largest) kept.push_back(mesh.triangles[t]);
  }
  mesh.triangles = std::move(kept);
  return static_cast<Index>(
      std::count_if(volume.begin(), volume.end(), [&](const auto& v) { return v.second < share * largest; }));
}

}  // namespace gyro
