// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/mesh_frame.hpp"

#include "core/math/quat.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gyro {

TriangleMesh framed(TriangleMesh mesh, const MeshFrame& frame) {
  const Vec3d axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const double angles[] = {frame.rotate.x, frame.rotate.y, frame.rotate.z};
  const bool shifts = frame.shift.x != 0 || frame.shift.y != 0 || frame.shift.z != 0;
  for (Vec3d& v : mesh.vertices) {
    if (frame.scale != 1) v = frame.scale * v;
    for (int k = 0; k < 3; ++k)
      if (angles[k] != 0) v = rotate(rotation_about(axes[k], angles[k]), v);
    if (shifts) v += frame.shift;
  }
  return mesh;
}

double Extents::largest() const {
  const Vec3d s = size();
  return std::max({s.x, s.y, s.z});
}

Extents extents_of(const TriangleMesh& mesh) {
  Extents e{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vec3d& v : mesh.vertices) {
    e.low = {std::min(e.low.x, v.x), std::min(e.low.y, v.y), std::min(e.low.z, v.z)};
    e.high = {std::max(e.high.x, v.x), std::max(e.high.y, v.y), std::max(e.high.z, v.z)};
  }
  return e;
}

std::string to_string(const Extents& e) {
  const bool metres = e.largest() >= 1;
  const double unit = metres ? 1 : 1e3, noise = 1e-9 * e.largest();
  const auto shown = [&](double x) { return std::abs(x) < noise ? 0.0 : unit * x; };
  char text[200];
  std::snprintf(text, sizeof text, "x %.4g..%.4g, y %.4g..%.4g, z %.4g..%.4g %s", shown(e.low.x), shown(e.high.x),
                shown(e.low.y), shown(e.high.y), shown(e.low.z), shown(e.high.z), metres ? "m" : "mm");
  return text;
}

}  // namespace gyro
