// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mesh.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

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

PrincipalAxes principal_axes(const std::array<double, 6>& t) {
  Eigen::Matrix3d m;
  m << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(m);
  const auto axis = [&](int k) {
    const Eigen::Vector3d v = solver.eigenvectors().col(k);
    return Vec3d{v[0], v[1], v[2]};
  };
  const Eigen::Vector3d l = solver.eigenvalues();
  return {{l[0], l[1], l[2]}, {axis(0), axis(1), cross(axis(0), axis(1))}};
}

EdgeCheck check_edges(const TriangleMesh& mesh) {
  struct Uses {
    Index forward = 0, backward = 0, triangle = 0;
  };
  std::map<std::pair<Index, Index>, Uses> edges;
  std::vector<Index> parent(mesh.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](Index t) {
    while (parent[t] != t) t = parent[t] = parent[parent[t]];
    return t;
  };
  for (Index t = 0; t < static_cast<Index>(mesh.triangles.size()); ++t) {
    const auto& v = mesh.triangles[t];
    for (const auto& [from, to] : {std::pair{v.x, v.y}, std::pair{v.y, v.z}, std::pair{v.z, v.x}}) {
      Uses& uses = edges.try_emplace(std::minmax(from, to), Uses{0, 0, t}).first->second;
      (from < to ? uses.forward : uses.backward) += 1;
      parent[root(t)] = root(uses.triangle);
    }
  }
  EdgeCheck check;
  for (const auto& [edge, uses] : edges) {
    const Index n = uses.forward + uses.backward;
    check.open += n == 1;
    check.crowded += n > 2;
    check.contradictory += n == 2 && uses.forward != 1;
  }
  for (Index t = 0; t < static_cast<Index>(parent.size()); ++t) check.bodies += parent[t] == t;
  return check;
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
