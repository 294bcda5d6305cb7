// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/relaxation.hpp"
#include "app/bench/speed/start_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro::bench {
namespace {

constexpr double fraction = 0.58;                          // of the volume that spheres fill
constexpr double usual_height = 0.86, usual_floor = 0.06;  // of the chamber; of the fill's floor [m]
constexpr double mesh_bottom = -0.05, mesh_top = 0.95;     // of the cones [m]
constexpr int around = 72, rows = 16;                      // quadrilaterals of a cone

/// Radius of a cone as a linear function of height.
struct Cone {
  double bottom, top, height;  ///< radii at z = 0 and z = height [m]
  double at(double z) const { return bottom + slope() * z; }
  double slope() const { return (top - bottom) / height; }
  /// Distance of the axis of a sphere that touches from the cone, over the sphere's radius.
  double secant() const { return std::hypot(1.0, slope()); }
};

struct Chamber {
  Cone outer, inner;
  double floor, height;  ///< [m]
};

Chamber chamber_of(double scale) {
  const double height = scale * usual_height;
  return {{scale * 0.464, scale * 0.714, height}, {scale * 0.393, scale * 0.321, height}, scale * usual_floor, height};
}

/// Height up to which a volume fills the chamber.
double fill_height(const Chamber& c, double volume) {
  constexpr int slices = 2000;
  const double slice = (c.height - c.floor) / slices;
  double filled = 0;
  for (int k = 0; k < slices; ++k) {
    const double z = c.floor + (k + 0.5) * slice, outer = c.outer.at(z), inner = c.inner.at(z);
    filled += std::numbers::pi * (outer * outer - inner * inner) * slice;
    if (filled >= volume) return z + 0.5 * slice;
  }
  return c.height;
}

/// A sphere's nearest place between the cones, of which the outer one has flat facets.
Vec3d between(const Chamber& c, double top, const Vec3d& x, double r) {
  const double z = std::clamp(x.z, c.floor + r, top - r), away = std::hypot(x.x, x.y);
  const double far = c.outer.at(z) * std::cos(std::numbers::pi / around) - r * c.outer.secant();
  const double near = std::min(c.inner.at(z) + r * c.inner.secant(), far);
  const double factor = std::clamp(away, near, far) / away;
  return {factor * x.x, factor * x.y, z};
}

/// @param inwards  where the normals point
TriangleMesh mesh_of(const Cone& cone, double scale, bool inwards) {
  TriangleMesh mesh;
  for (int b = 0; b <= rows; ++b)
    for (int a = 0; a < around; ++a) {
      const double z = scale * (mesh_bottom + (mesh_top - mesh_bottom) * b / rows);
      const double angle = 2 * std::numbers::pi * a / around;
      mesh.vertices.push_back({cone.at(z) * std::cos(angle), cone.at(z) * std::sin(angle), z});
    }
  const auto vertex = [](int a, int b) { return static_cast<Index>(b * around + a % around); };
  for (int b = 0; b < rows; ++b)
    for (int a = 0; a < around; ++a) {
      const Index p = vertex(a, b), q = vertex(a + 1, b), r = vertex(a + 1, b + 1), s = vertex(a, b + 1);
      mesh.triangles.push_back(inwards ? Vec3<Index>{p, r, q} : Vec3<Index>{p, q, r});
      mesh.triangles.push_back(inwards ? Vec3<Index>{p, s, r} : Vec3<Index>{p, r, s});
    }
  return mesh;
}

}  // namespace

StartState spheres_between_cones(const StartRecipe& recipe) {
  StartState state;
  // A small chamber would have no room for the largest spheres: fewer of them fill the usual one less high.
  const double scale = std::max(1.0, scene_scale(recipe)), clear = 0.006;  // [m]
  const Chamber chamber = chamber_of(scale);
  state.radii = mixed_radii(recipe);
  const double top = std::max(fill_height(chamber, volume_of(state.radii) / fraction),
                              chamber.floor + 2.2 * *std::ranges::max_element(state.radii));
  const double wide = chamber.outer.at(chamber.height);
  const auto inside = [&](const Vec3d& x) {
    const double away = std::hypot(x.x, x.y);
    return away < chamber.outer.at(x.z) - clear && away > chamber.inner.at(x.z) + clear;
  };
  state.centres =
      jittered_lattice(recipe.particles, {{-wide, -wide, chamber.floor}, {wide, wide, top}, inside}, recipe.seed);
  separate(state.centres, state.radii, [&](const Vec3d& x, double r) { return between(chamber, top, x, r); });
  shrink_to_fit(state.centres, state.radii);
  state.velocities = scattered_velocities({0, 0, -1.0}, recipe);
  state.meshes = {{"outer", mesh_of(chamber.outer, scale, true)}, {"inner", mesh_of(chamber.inner, scale, false)}};
  state.sizes = {{"outer_radius", wide}, {"height", scale * mesh_top}};
  state.overrides = {"walls.outer.material=rock", "walls.inner.material=rock",
                     "walls.inner.motion={circular: {radius: 10 mm, period: 50 ms}}"};
  return state;
}

}  // namespace gyro::bench
