// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/walls/nearest.hpp"

#include <algorithm>

namespace gyro {

Nearest nearest_within(const MeshGrid& mesh, const Vec3d& centre, double reach) {
  constexpr double rounding = 1e-14;  // relative: all triangles at the same distance are compared
  Nearest best;
  double within = reach;
  const auto compare = [&](Index k) {  // triangles come in any order, some more than once
    NearPoint point;
    const WallTriangle& t = mesh.triangles()[static_cast<std::size_t>(k)];
    if (near_triangle(t, centre, within, point) == Place::out_of_reach) return;
    const bool same = best.triangle != none && !comes_before(point, best.point) && !comes_before(best.point, point);
    if (best.triangle != none && !comes_before(point, best.point) && !(same && k < best.triangle)) return;
    best = {k, point};
    within = std::min(within, point.height * (1 + rounding));
  };
  visit_near(mesh.view(), centre, reach, compare);
  return best;
}

Nearest nearest_triangle(const MeshGrid& mesh, const Vec3d& centre, double reach) {
  Nearest best;
  for (double within = reach; best.triangle == none && within <= 64 * reach; within *= 4)
    best = nearest_within(mesh, centre, within);
  return best;
}

}  // namespace gyro
