// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/speed/close_pairs.hpp"
#include "core/scene/triangle_mesh.hpp"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace gyro::bench {

/// What a start state is made from.
struct StartRecipe {
  std::uint64_t seed = 0;
  int particles = 0;  ///< more of them fill a larger scene of the same shape
};

/// Spheres, bonds and meshes at t = 0, with what the case file must be told about them.
struct StartState {
  std::vector<Vec3d> centres;     ///< [m]
  std::vector<double> radii;      ///< [m]
  std::vector<Vec3d> velocities;  ///< [m/s]; empty: at rest
  std::vector<ClosePair> bonds;
  std::vector<std::pair<std::string, TriangleMesh>> meshes;  ///< by the name of the wall
  std::vector<std::pair<std::string, double>> sizes;         ///< of the scene, for other programs [m]
  std::vector<std::string> overrides;                        ///< of the case, without those that name files
};

/// S1: loose spheres of 8 to 22 mm radius that fill 60 % of a box and fall obliquely. Nothing overlaps.
StartState loose_spheres(const StartRecipe& recipe);
/// S2: a cylinder of spheres of 10 mm radius, bonded where surfaces are closer than 1.5 mm, between two plates.
StartState bonded_cylinder(const StartRecipe& recipe);
/// S2r: rocks of 136 spheres in one layer between two plates, all copies of one, turned about the vertical. The number
/// of particles is rounded to whole rocks.
StartState bonded_rocks(const StartRecipe& recipe);
/// S3: loose spheres between two cones of triangles, as in a crusher.
StartState spheres_between_cones(const StartRecipe& recipe);

/// Particles of a scene of the usual size, to which the lengths of larger and smaller ones are relative.
inline constexpr int usual_particles = 20000;
/// Factor on the lengths of a scene.
double scene_scale(const StartRecipe& recipe);

/// `count` radii, uniform from 8 to 22 mm.
std::vector<double> mixed_radii(const StartRecipe& recipe);
/// The same velocity for all, plus up to 0.1 m/s along each axis.
std::vector<Vec3d> scattered_velocities(const Vec3d& mean, const StartRecipe& recipe);
double volume_of(const std::vector<double>& radii);
/// Makes radii so much smaller that no two spheres overlap.
void shrink_to_fit(const std::vector<Vec3d>& centres, std::vector<double>& radii);

}  // namespace gyro::bench
