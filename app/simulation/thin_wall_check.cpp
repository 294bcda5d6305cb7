// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulation/thin_wall_check.hpp"

#include "core/feed/bed.hpp"
#include "core/scene/wall_motion.hpp"

#include <algorithm>
#include <sstream>

namespace gyro {
namespace {

/// Whether the straight line from p to q passes through a triangle.
bool passes(const Vec3d& p, const Vec3d& q, const WallTriangle& t) {
  const double from = dot(p - t.a, t.normal), to = dot(q - t.a, t.normal);
  if (!(from * to < 0)) return false;
  const Vec3d x = p + from / (from - to) * (q - p);
  const auto left_of = [&](const Vec3d& a, const Vec3d& b) { return dot(cross(b - a, x - a), t.normal) >= 0; };
  return left_of(t.a, t.b) && left_of(t.b, t.c) && left_of(t.c, t.a);
}

bool passes(const Vec3d& p, const Vec3d& q, const MeshGrid& grid) {
  const std::vector<Index> near = grid.candidates(0.5 * (p + q), 0.5 * norm(q - p));
  return std::any_of(near.begin(), near.end(),
                     [&](Index t) { return passes(p, q, grid.triangles()[static_cast<std::size_t>(t)]); });
}

}  // namespace

ThinWallCheck::ThinWallCheck(const Scene& scene) {
  for (std::size_t w = 0; w < scene.walls.size(); ++w)
    if (const auto* mesh = std::get_if<TriangleMesh>(&scene.walls[w].shape))
      mesh_walls_.push_back({w, scene.walls[w].name, MeshGrid(*mesh)});
}

std::optional<std::string> ThinWallCheck::find(const ParticleSnapshot& particles,
                                               std::span<const WallPose> poses) const {
  for (const MeshWall& wall : mesh_walls_)
    if (auto found = find_through(wall, poses[wall.number], particles)) return found;
  return {};
}

/// Of two spheres that touch through a wall at least one touches the wall.
std::optional<std::string> ThinWallCheck::find_through(const MeshWall& wall, const WallPose& pose,
                                                       const ParticleSnapshot& s) {
  Bed touching;
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < s.size(); ++k)
    if (touch_mesh(wall.grid.view(), to_body(pose, s.position[k]), s.radius[k]).count > 0) {
      touching.add(s.position[k], s.radius[k]);
      rows.push_back(k);
    }
  if (rows.empty()) return {};
  for (std::size_t k = 0; k < s.size(); ++k)
    for (const Index number : touching.overlapped(s.position[k], s.radius[k])) {
      const std::size_t other = rows[static_cast<std::size_t>(number)];
      if (other == k) continue;
      if (!passes(to_body(pose, s.position[k]), to_body(pose, s.position[other]), wall.grid)) continue;
      const double overlap = s.radius[k] + s.radius[other] - norm(s.position[k] - s.position[other]);
      std::ostringstream words;
      words.precision(3);
      words << "particles " << s.id[k] << " and " << s.id[other] << " touch each other through wall " << wall.name
            << ", by " << overlap * 1e3 << " mm; use a wall that is thicker than the overlaps on both of its sides";
      return words.str();
    }
  return {};
}

}  // namespace gyro
