// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/nearest.hpp"

namespace gyro {

Nearest nearest_within(const MeshGrid& mesh, const Vec3d& centre, double reach) {
  Nearest best;
  for (const Index k : mesh.candidates(centre, reach)) {
    NearPoint point;
    const WallTriangle& t = mesh.triangles()[static_cast<std::size_t>(k)];
    if (near_triangle(t, centre, reach, point) == Place::out_of_reach) continue;
    if (best.triangle == none || comes_before(point, best.point)) best = {k, point};
  }
  return best;
}

Nearest nearest_triangle(const MeshGrid& mesh, const Vec3d& centre, double reach) {
  Nearest best;
  for (double within = reach; best.triangle == none && within <= 64 * reach; within *= 4)
    best = nearest_within(mesh, centre, within);
  return best;
}

}  // namespace gyro
