// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/scenes.hpp"

#include <cmath>

namespace gyro::verify {

Material elastic(double youngs, double poisson_ratio, double density) {
  return {"rock", density, youngs / (2 * (1 + poisson_ratio)), poisson_ratio};
}

Material rigid() {
  return {"rigid", 1, 1e25, 0.3};
}

double youngs_against_rigid(const Material& m) {
  return 2 * m.shear_modulus / (1 - m.poisson_ratio);  // E/(1 - nu^2)
}

double youngs_of_pair(const Material& m) {
  return 0.5 * youngs_against_rigid(m);
}

double sphere_mass(double radius, double density) {
  return density * 4.0 / 3 * pi * radius * radius * radius;
}

Scene scene_of(const Material& rock, const Material& wall, const PairProperties& pair, double dt) {
  Scene scene;
  scene.materials = {rock, wall};
  scene.pairs.assign(4, pair);
  scene.rolling = pair.rolling_friction > 0;
  scene.gravity = {0, 0, 0};
  scene.dt = dt;
  return scene;
}

Wall floor_plane() {
  return {"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1};
}

Wall floor_mesh(double half) {
  return {
      "floor",
      TriangleMesh{{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{0, 1, 2}, {0, 2, 3}}},
      Fixed{}, 1};
}

double static_overlap(double youngs, double radius, double force) {
  return std::pow(force / (4.0 / 3 * youngs * std::sqrt(radius)), 2.0 / 3);
}

NewRock sphere(ParticleId id, Vec3d position, Vec3d velocity, double radius, double density, Vec3d angular_velocity) {
  NewRock rock;
  rock.id = none;
  rock.particles.push_back({id, position, velocity, angular_velocity, radius, density});
  return rock;
}

}  // namespace gyro::verify
