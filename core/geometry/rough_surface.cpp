// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/rough_surface.hpp"

#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

namespace gyro {
namespace {

Vec3d unit(const Vec3d& v) {
  return (1 / norm(v)) * v;
}

TriangleMesh icosahedron() {
  constexpr double g = std::numbers::phi;
  TriangleMesh mesh{{{-1, g, 0},
                     {1, g, 0},
                     {-1, -g, 0},
                     {1, -g, 0},
                     {0, -1, g},
                     {0, 1, g},
                     {0, -1, -g},
                     {0, 1, -g},
                     {g, 0, -1},
                     {g, 0, 1},
                     {-g, 0, -1},
                     {-g, 0, 1}},
                    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (Vec3d& v : mesh.vertices) v = unit(v);
  return mesh;
}

/// Divides each triangle of the sphere into four.
TriangleMesh divided(const TriangleMesh& sphere) {
  TriangleMesh finer{sphere.vertices, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, inserted] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(finer.vertices.size()));
    if (inserted) finer.vertices.push_back(unit(sphere.vertices[a] + sphere.vertices[b]));
    return entry->second;
  };
  for (const auto& t : sphere.triangles) {
    const Index a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
    for (const Vec3<Index>& part : {Vec3<Index>{t.x, a, c}, {t.y, b, a}, {t.z, c, b}, {a, b, c}})
      finer.triangles.push_back(part);
  }
  return finer;
}

/// Distance from the origin to the surface of a convex solid around it.
double radius_towards(const TriangleMesh& convex, const Vec3d& direction) {
  double radius = std::numeric_limits<double>::infinity();
  for (const auto& t : convex.triangles) {
    const Vec3d a = convex.vertices[t.x];
    const Vec3d normal = cross(convex.vertices[t.y] - a, convex.vertices[t.z] - a);
    const double along = dot(normal, direction);
    if (along > 0) radius = std::min(radius, dot(normal, a) / along);
  }
  return radius;
}

/// Random waves on the unit sphere.
class Noise {
 public:
  Noise(std::uint64_t seed, std::uint64_t number, std::uint32_t draw) {
    const auto next = [&] { return uniform(seed, Stream::shape, number, draw++); };
    for (int octave = 0; octave < octaves; ++octave) {
      for (int k = 0; k < waves; ++k) {
        const double z = 2 * next() - 1, azimuth = 2 * std::numbers::pi * next(), r = std::sqrt(1 - z * z);
        const double wave_number = first_wave_number * std::exp2(octave) * (0.75 + 0.5 * next());
        waves_.push_back({wave_number * Vec3d{r * std::cos(azimuth), r * std::sin(azimuth), z},
                          2 * std::numbers::pi * next(), std::exp2(-octave)});
        variance_ += std::exp2(-2 * octave) / 2;
      }
    }
  }

  double at(const Vec3d& direction) const {
    double sum = 0;
    for (const Wave& w : waves_) sum += w.height * std::cos(dot(w.vector, direction) + w.phase);
    return sum / std::sqrt(variance_);
  }

 private:
  static constexpr int octaves = 3, waves = 8;
  static constexpr double first_wave_number = std::numbers::pi;  // one wave over the diameter
  struct Wave {
    Vec3d vector;
    double phase, height;
  };
  std::vector<Wave> waves_;
  double variance_ = 0;
};

}  // namespace

TriangleMesh roughened(const TriangleMesh& convex, double roughness, std::uint64_t seed, std::uint64_t number,
                       std::uint32_t first_draw) {
  TriangleMesh rough = icosahedron();
  for (int k = 0; k < 3; ++k) rough = divided(rough);
  const Noise noise(seed, number, first_draw);
  for (Vec3d& v : rough.vertices) v = (radius_towards(convex, v) * std::exp(roughness * noise.at(v))) * v;
  return rough;
}

}  // namespace gyro
