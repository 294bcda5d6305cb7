// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/make_dem.hpp"

#include <cstdint>
#include <functional>
#include <vector>

// Small scenes that several groups share.

namespace gyro::verify {

inline constexpr double pi = 3.14159265358979323846;

/// A material by Young's modulus.
Material elastic(double youngs, double poisson_ratio, double density);
/// So stiff that it has no part in a contact's compliance.
Material rigid();
/// E* of the material against a rigid wall, or of two equal bodies [Pa].
double youngs_against_rigid(const Material& material);
double youngs_of_pair(const Material& material);

double sphere_mass(double radius, double density);

/// Rock of `rock` (material 0) and walls of `wall` (material 1), no gravity, all pairs alike.
Scene scene_of(const Material& rock, const Material& wall, const PairProperties& pair, double dt);

/// Walls of material 1, rock above z = 0 and their normal z.
Wall floor_plane();
/// A floor of two triangles that reaches `half` to each side.
Wall floor_mesh(double half);

/// Overlap of a sphere pressed on a wall by a force: (F / (4/3 E* sqrt(R)))^(2/3) [m].
double static_overlap(double youngs, double radius, double force);

/// A loose sphere.
NewRock sphere(ParticleId id, Vec3d position, Vec3d velocity, double radius, double density,
               Vec3d angular_velocity = {0, 0, 0});

/// A scene that counts its own steps.
class Stage {
 public:
  Stage(const Scene& scene, Precision precision) : dt_(scene.dt), dem_(make_cpu_dem(scene, precision, 1)) {}

  void insert(const std::vector<NewRock>& rocks) { dem_->insert(rocks); }
  void advance(int steps, const MantlePath& path = {}) {
    dem_->advance({step_, steps, dt_}, path);
    step_ += steps;
  }
  double time() const { return static_cast<double>(step_) * dt_; }
  double dt() const { return dt_; }
  Dem& dem() { return *dem_; }

 private:
  double dt_;
  std::int64_t step_ = 0;
  std::unique_ptr<Dem> dem_;
};

}  // namespace gyro::verify
