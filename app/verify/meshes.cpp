// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/meshes.hpp"

#include "app/verify/rig.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::verify {
namespace {

double draw(int thing, std::uint32_t k) {
  return uniform(11, Stream::place, static_cast<std::uint32_t>(thing), k);
}

/// Smallest height of a triangle over its longest edge.
double slimness(const TriangleMesh& mesh, const Vec3<Index>& t) {
  const auto at = [&](Index k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
  const double longest2 = std::max({norm2(at(t.x) - at(t.y)), norm2(at(t.y) - at(t.z)), norm2(at(t.z) - at(t.x))});
  return norm(cross(at(t.y) - at(t.x), at(t.z) - at(t.x))) / longest2;
}

}  // namespace

TriangleMesh split_square(double half, int splits) {
  TriangleMesh mesh{{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  for (int i = 0, done = 0; done < splits; ++i) {
    const auto t = static_cast<std::size_t>(draw(i, 0) * static_cast<double>(mesh.triangles.size()));
    const Vec3<Index> old = mesh.triangles[t];
    if (slimness(mesh, old) < 0.01) continue;
    const double u = draw(i, 1), v = (1 - u) * draw(i, 2) * (i % 4 == 0 ? 1e-3 : 1);  // every fourth hugs an edge
    const auto at = [&](Index k) { return mesh.vertices[static_cast<std::size_t>(k)]; };
    const auto added = static_cast<Index>(mesh.vertices.size());
    mesh.vertices.push_back((1 - u - v) * at(old.x) + u * at(old.y) + v * at(old.z));
    mesh.triangles[t] = {old.x, old.y, added};
    mesh.triangles.push_back({old.y, old.z, added});
    // Some triangles look down: both sides of a mesh can be touched.
    mesh.triangles.push_back(i % 3 == 0 ? Vec3<Index>{added, old.x, old.z} : Vec3<Index>{old.z, old.x, added});
    ++done;
  }
  return mesh;
}

TriangleMesh fan(int n) {
  TriangleMesh mesh{{{0, 0, 0}}, {}};
  for (int k = 0; k < n; ++k) {
    mesh.vertices.push_back({std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0});
    mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % n});
  }
  return mesh;
}

TriangleMesh folded(double degrees, double half) {
  const double rise = (90 - degrees / 2) * pi / 180, x = half * std::cos(rise), z = half * std::sin(rise);
  return {{{-x, -half, z}, {0, -half, 0}, {0, half, 0}, {-x, half, z}, {x, -half, z}, {x, half, z}},
          {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}}};
}

double hertz_force(const Material& material, double radius, double overlap) {
  return overlap > 0 ? 4.0 / 3 * youngs_against_rigid(material) * std::sqrt(radius * overlap) * overlap : 0;
}

Vec3d force_on_held(const std::vector<Wall>& walls, const Material& material, double radius, const Vec3d& centre,
                    Precision precision) {
  Scene scene = scene_of(material, rigid(), {0, 1, 0}, 1e-9);
  scene.walls = walls;
  Stage stage(scene, precision);
  stage.insert({sphere(0, centre, {0, 0, 0}, radius, held)});
  stage.advance(1);
  return stage.dem().particles().force[0];
}

}  // namespace gyro::verify
