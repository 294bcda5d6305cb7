// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mesh_repair.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace gyro {
namespace {

using Cell = std::array<std::int64_t, 3>;
using Edge = std::pair<Index, Index>;

std::array<Edge, 3> edges_of(const Vec3<Index>& t) {
  return {Edge{t.x, t.y}, Edge{t.y, t.z}, Edge{t.z, t.x}};
}

Edge undirected(const Edge& e) {
  return {std::min(e.first, e.second), std::max(e.first, e.second)};
}

/// Finds an earlier vertex within a distance, in cells of that size.
class Welder {
 public:
  Welder(const Vec3d& origin, double distance) : origin_(origin), distance_(distance) {}

  Index vertex(const Vec3d& p, std::vector<Vec3d>& vertices) {
    const Cell home = cell(p);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const auto [begin, end] = cells_.equal_range({home[0] + dx, home[1] + dy, home[2] + dz});
          for (auto it = begin; it != end; ++it) {
            if (norm(vertices[it->second] - p) <= distance_) return it->second;
          }
        }
      }
    }
    cells_.insert({home, static_cast<Index>(vertices.size())});
    vertices.push_back(p);
    return static_cast<Index>(vertices.size()) - 1;
  }

 private:
  Cell cell(const Vec3d& p) const {
    const auto part = [&](double x) { return static_cast<std::int64_t>(std::floor(x / distance_)); };
    return {part(p.x - origin_.x), part(p.y - origin_.y), part(p.z - origin_.z)};
  }
  Vec3d origin_;
  double distance_;
  std::multimap<Cell, Index> cells_;
};

}  // namespace

TriangleMesh weld(const TriangleMesh& soup, double distance) {
  if (soup.vertices.empty() || !(distance > 0)) return soup;
  Welder welder(bounding_box(soup).low, distance);
  TriangleMesh mesh;
  std::vector<Index> place(soup.vertices.size(), none);
  const auto welded = [&](Index v) {
    if (place[v] == none) place[v] = welder.vertex(soup.vertices[v], mesh.vertices);
    return place[v];
  };
  for (const auto& t : soup.triangles) {
    const Index a = welded(t.x), b = welded(t.y), c = welded(t.z);
    mesh.triangles.push_back({a, b, c});
  }
  return mesh;
}

Dropped drop_useless_triangles(TriangleMesh& mesh) {
  Dropped dropped;
  std::set<std::array<Index, 3>> seen;
  std::vector<Vec3<Index>> kept;
  for (const auto& t : mesh.triangles) {
    std::array<Index, 3> key{t.x, t.y, t.z};
    std::sort(key.begin(), key.end());
    if (key[0] == key[1] || key[1] == key[2]) {
      ++dropped.flat;
    } else if (!seen.insert(key).second) {
      ++dropped.repeated;
    } else {
      kept.push_back(t);
    }
  }
  mesh.triangles = std::move(kept);
  return dropped;
}

namespace {

using EdgeUsers = std::map<Edge, std::vector<Index>>;

/// Decides for all triangles connected with the first one, over edges of two triangles, which to
/// turn so that they agree: 0 keep, 1 turn; the fewer are turned. @param turn -1: not decided yet
void decide_turns(const TriangleMesh& mesh, const EdgeUsers& users, Index first, std::vector<int>& turn) {
  const auto runs_through = [&](Index t, const Edge& e) {
    const auto edges = edges_of(mesh.triangles[t]);
    return std::find(edges.begin(), edges.end(), e) != edges.end();
  };
  std::vector<Index> connected{first};
  turn[first] = 0;
  for (std::size_t next = 0; next < connected.size(); ++next) {
    const Index t = connected[next];
    for (const Edge& e : edges_of(mesh.triangles[t])) {
      const auto& pair = users.at(undirected(e));
      if (pair.size() != 2) continue;
      const Index other = pair[0] == t ? pair[1] : pair[0];
      if (turn[other] >= 0) continue;
      turn[other] = runs_through(other, e) ? 1 - turn[t] : turn[t];
      connected.push_back(other);
    }
  }
  const auto turned = std::count_if(connected.begin(), connected.end(), [&](Index t) { return turn[t] == 1; });
  if (2 * turned > static_cast<std::ptrdiff_t>(connected.size())) {
    for (const Index t : connected) turn[t] = 1 - turn[t];
  }
}

}  // namespace

Index turn_outwards(TriangleMesh& mesh) {
  const Index n = static_cast<Index>(mesh.triangles.size());
  EdgeUsers users;
  for (Index t = 0; t < n; ++t) {
    for (const Edge& e : edges_of(mesh.triangles[t])) users[undirected(e)].push_back(t);
  }
  std::vector<int> turn(n, -1);
  for (Index t = 0; t < n; ++t) {
    if (turn[t] < 0) decide_turns(mesh, users, t, turn);
  }
  for (Index t = 0; t < n; ++t) {
    if (turn[t] == 1) std::swap(mesh.triangles[t].y, mesh.triangles[t].z);
  }
  const Index turned = static_cast<Index>(std::count(turn.begin(), turn.end(), 1));
  if (mass_properties(mesh).volume >= 0) return turned;
  for (auto& t : mesh.triangles) std::swap(t.y, t.z);
  return n - turned;
}

}  // namespace gyro
