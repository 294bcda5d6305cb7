// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

namespace gyro {

TriangleMesh convex_hull(const std::vector<Vec3d>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size());
  for (const Vec3d& p : points) input.emplace_back(p.x, p.y, p.z);
  Surface surface;
  CGAL::convex_hull_3(input.begin(), input.end(), surface);

  TriangleMesh mesh;
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    mesh.vertices.push_back({p.x(), p.y(), p.z()});
  }
  for (const auto f : surface.faces()) {
    Index corner[3];
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface)) {
      if (k < 3) corner[k++] = static_cast<Index>(v.idx());
    }
    mesh.triangles.push_back({corner[0], corner[1], corner[2]});
  }
  return mesh;
}

}  // namespace gyro
