// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mesh.hpp"

#include <algorithm>

namespace gyro {

MassProperties mass_properties(const TriangleMesh& mesh) {
  MassProperties p;
  if (mesh.triangles.empty()) return p;
  // Relative to a point of the mesh: far from the origin the sums would cancel.
  const Vec3d origin = mesh.vertices[mesh.triangles[0].x];
  Vec3d first{0, 0, 0};
  std::array<double, 6> second{};  // integrals of xx, yy, zz, xy, yz, zx
  for (const auto& t : mesh.triangles) {
    const Vec3d a = mesh.vertices[t.x] - origin, b = mesh.vertices[t.y] - origin, c = mesh.vertices[t.z] - origin;
    const double six_volumes = dot(a, cross(b, c));
    const Vec3d sum = a + b + c;
    p.volume += six_volumes / 6;
    first += (six_volumes / 24) * sum;
    // Over a tetrahedron with one corner at 0: integral x_p x_q = V/20 (s_p s_q + sum over corners of x_p x_q).
    const double k = six_volumes / 120;
    const auto moment = [&](double Vec3d::*u, double Vec3d::*v) {
      return k * (sum.*u * sum.*v + a.*u * a.*v + b.*u * b.*v + c.*u * c.*v);
    };
    second[0] += moment(&Vec3d::x, &Vec3d::x);
    second[1] += moment(&Vec3d::y, &Vec3d::y);
    second[2] += moment(&Vec3d::z, &Vec3d::z);
    second[3] += moment(&Vec3d::x, &Vec3d::y);
    second[4] += moment(&Vec3d::y, &Vec3d::z);
    second[5] += moment(&Vec3d::z, &Vec3d::x);
  }
  if (p.volume == 0) return p;
  const Vec3d g = (1 / p.volume) * first;
  p.centroid = origin + g;
  const double xx = second[0] - p.volume * g.x * g.x, yy = second[1] - p.volume * g.y * g.y,
               zz = second[2] - p.volume * g.z * g.z;
  p.inertia = {yy + zz,
               zz + xx,
               xx + yy,
               -(second[3] - p.volume * g.x * g.y),
               -(second[4] - p.volume * g.y * g.z),
               -(second[5] - p.volume * g.z * g.x)};
  return p;
}

double triangle_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return norm(cross(b - a, c - a)) / 2;
}

double surface_area(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += triangle_area(mesh.vertices[t.x], mesh.vertices[t.y], mesh.vertices[t.z]);
  return area;
}

Box bounding_box(const TriangleMesh& mesh) {
  Box box{mesh.vertices.at(0), mesh.vertices.at(0)};
  for (const Vec3d& v : mesh.vertices) {
    box.low = {std::min(box.low.x, v.x), std::min(box.low.y, v.y), std::min(box.low.z, v.z)};
    box.high = {std::max(box.high.x, v.x), std::max(box.high.y, v.y), std::max(box.high.z, v.z)};
  }
  return box;
}

TriangleMesh moved(TriangleMesh mesh, const Vec3d& origin, double scale) {
  for (Vec3d& v : mesh.vertices) v = scale * (v - origin);
  return mesh;
}

}  // namespace gyro
