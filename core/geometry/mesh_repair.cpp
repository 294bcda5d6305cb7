// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mesh_repair.hpp"

#include "core/geometry/edges.hpp"
#include "core/geometry/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace gyro {
namespace {

using Cell = std::array<std::int64_t, 3>;

/// Finds an earlier vertex within a distance, by a grid with cells of that size.
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
  std::vector<Index> number(soup.vertices.size(), none);  // of the welded vertex, by vertex of the soup
  const auto welded = [&](Index v) {
    if (number[v] == none) number[v] = welder.vertex(soup.vertices[v], mesh.vertices);
    return number[v];
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

/// The triangles of every edge, by undirected edge.
using EdgeUsers = std::map<Edge, std::vector<Index>>;

/// Whether to flip a triangle.
enum class Flip : char { undecided, keep, flip };

Flip opposite(Flip f) {
  return f == Flip::keep ? Flip::flip : Flip::keep;
}

/// Decides which triangles to flip so that all triangles that are connected with the first one over edges of two
/// triangles agree. The smaller part is flipped.
void decide_flips(const TriangleMesh& mesh, const EdgeUsers& users, Index first, std::vector<Flip>& flips) {
  const auto runs_through = [&](Index t, const Edge& e) {
    const auto edges = edges_of(mesh.triangles[t]);
    return std::find(edges.begin(), edges.end(), e) != edges.end();
  };
  std::vector<Index> connected{first};
  flips[first] = Flip::keep;
  for (std::size_t next = 0; next < connected.size(); ++next) {
    const Index t = connected[next];
    for (const Edge& e : edges_of(mesh.triangles[t])) {
      const auto& pair = users.at(undirected(e));
      if (pair.size() != 2) continue;
      const Index other = pair[0] == t ? pair[1] : pair[0];
      if (flips[other] != Flip::undecided) continue;
      flips[other] = runs_through(other, e) ? opposite(flips[t]) : flips[t];
      connected.push_back(other);
    }
  }
  const auto flipped =
      std::count_if(connected.begin(), connected.end(), [&](Index t) { return flips[t] == Flip::flip; });
  if (2 * flipped > static_cast<std::ptrdiff_t>(connected.size())) {
    for (const Index t : connected) flips[t] = opposite(flips[t]);
  }
}

}  // namespace

Index orient_outwards(TriangleMesh& mesh) {
  const Index n = static_cast<Index>(mesh.triangles.size());
  EdgeUsers users;
  for (Index t = 0; t < n; ++t) {
    for (const Edge& e : edges_of(mesh.triangles[t])) users[undirected(e)].push_back(t);
  }
  std::vector<Flip> flips(mesh.triangles.size(), Flip::undecided);
  for (Index t = 0; t < n; ++t) {
    if (flips[t] == Flip::undecided) decide_flips(mesh, users, t, flips);
  }
  for (Index t = 0; t < n; ++t) {
    if (flips[t] == Flip::flip) std::swap(mesh.triangles[t].y, mesh.triangles[t].z);
  }
  const Index flipped = static_cast<Index>(std::count(flips.begin(), flips.end(), Flip::flip));
  if (mass_properties(mesh).volume >= 0) return flipped;
  for (auto& t : mesh.triangles) std::swap(t.y, t.z);
  return n - flipped;
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
