// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/inside.hpp"

#include "core/geometry/mesh.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>

namespace gyro {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

/// With more faces, testing every plane is slower than the tree.
constexpr std::size_t max_planes = 500;

Surface to_surface(const TriangleMesh& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const Vec3d& v : mesh.vertices) vertices.push_back(surface.add_vertex({v.x, v.y, v.z}));
  for (const auto& t : mesh.triangles) surface.add_face(vertices[t.x], vertices[t.y], vertices[t.z]);
  return surface;
}

}  // namespace

struct InsideTest::Tree {
  explicit Tree(const TriangleMesh& mesh) : surface(to_surface(mesh)), side(surface) {
    side(Kernel::Point_3(0, 0, 0));  // builds the tree now, on one thread
  }
  Surface surface;
  CGAL::Side_of_triangle_mesh<Surface, Kernel> side;
};

InsideTest::InsideTest(const TriangleMesh& solid) {
  if (solid.triangles.size() <= max_planes) {
    for (const auto& t : solid.triangles) {
      const Vec3d a = solid.vertices[t.x];
      const Vec3d n = cross(solid.vertices[t.y] - a, solid.vertices[t.z] - a);
      if (norm(n) == 0) continue;
      const Vec3d unit = (1 / norm(n)) * n;
      planes_.push_back({unit, dot(unit, a)});
    }
    const Box box = bounding_box(solid);
    const double tolerance = 1e-9 * norm(box.high - box.low);
    const bool all_below = std::all_of(planes_.begin(), planes_.end(), [&](const Plane& p) {
      return std::all_of(solid.vertices.begin(), solid.vertices.end(),
                         [&](const Vec3d& v) { return dot(p.normal, v) <= p.offset + tolerance; });
    });
    if (all_below) return;
    planes_.clear();
  }
  tree_ = std::make_unique<Tree>(solid);
}

InsideTest::~InsideTest() = default;
InsideTest::InsideTest(InsideTest&&) noexcept = default;
InsideTest& InsideTest::operator=(InsideTest&&) noexcept = default;

bool InsideTest::contains(const Vec3d& point) const {
  if (convex()) {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const Plane& p) { return dot(p.normal, point) <= p.offset; });
  }
  return tree_->side({point.x, point.y, point.z}) != CGAL::ON_UNBOUNDED_SIDE;
}

}  // namespace gyro
