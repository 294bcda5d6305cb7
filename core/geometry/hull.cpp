// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/hull.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <array>
#include <map>

namespace gyro {

TriangleMesh convex_hull(const std::vector<Vec3d>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  std::vector<Kernel::Point_3> input;
  input.reserve(points.size());
  for (const Vec3d& p : points) input.emplace_back(p.x, p.y, p.z);
  Surface surface;
  CGAL::convex_hull_3(input.begin(), input.end(), surface);

  // CGAL numbers vertices and faces by memory address, which differs between runs; number them by the input instead.
  std::map<std::array<double, 3>, Index> input_order;
  for (const Vec3d& p : points) input_order.try_emplace({p.x, p.y, p.z}, static_cast<Index>(input_order.size()));
  std::map<Index, Vec3d> corners;
  const auto number_of = [&](Surface::Vertex_index v) {
    const auto& p = surface.point(v);
    return input_order.at({p.x(), p.y(), p.z()});
  };
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    corners[number_of(v)] = {p.x(), p.y(), p.z()};
  }
  TriangleMesh mesh;
  std::map<Index, Index> vertex_of;  // by number
  for (const auto& [number, p] : corners) {
    vertex_of[number] = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.push_back(p);
  }
  std::vector<std::array<Index, 3>> faces;
  for (const auto f : surface.faces()) {
    std::array<Index, 3> face{};
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
      face.at(k++) = vertex_of.at(number_of(v));
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.push_back(face);
  }
  std::sort(faces.begin(), faces.end());
  for (const auto& [a, b, c] : faces) mesh.triangles.push_back({a, b, c});
  return mesh;
}

}  // namespace gyro
