// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/edges.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace gyro {

std::array<Edge, 3> edges_of(const Vec3<Index>& t) {
  return {Edge{t.x, t.y}, Edge{t.y, t.z}, Edge{t.z, t.x}};
}

Edge undirected(const Edge& e) {
  return {std::min(e.first, e.second), std::max(e.first, e.second)};
}

EdgeCheck check_edges(const TriangleMesh& mesh) {
  struct Uses {
    Index forward = 0, backward = 0;
  };
  std::map<Edge, Uses> edges;
  for (const auto& t : mesh.triangles) {
    for (const Edge& e : edges_of(t)) {
      Uses& uses = edges[undirected(e)];
      (e.first < e.second ? uses.forward : uses.backward) += 1;
    }
  }
  EdgeCheck check;
  for (const auto& [edge, uses] : edges) {
    const Index n = uses.forward + uses.backward;
    check.open += n == 1;
    check.crowded += n > 2;
    check.contradictory += n == 2 && uses.forward != 1;
  }
  const std::vector<Index> body = bodies_of(mesh);
  for (Index t = 0; t < static_cast<Index>(body.size()); ++t) check.bodies += body[t] == t;
  return check;
}

std::vector<Index> bodies_of(const TriangleMesh& mesh) {
  std::vector<Index> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  std::map<Edge, Index> first_user;
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    for (const Edge& e : edges_of(mesh.triangles[t])) {
      const Index other = root(first_user.try_emplace(undirected(e), t).first->second), own = root(t);
      parent[std::max(own, other)] = std::min(own, other);
    }
  }
  for (Index t = 0; t < static_cast<Index>(parent.size()); ++t) parent[t] = root(t);
  return parent;
}

}  // namespace gyro
