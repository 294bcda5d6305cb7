// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/scenes.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::verify {

/// A sphere on a floor or a slope, at its static overlap from the start. Gravity leans instead of the floor: x is
/// downhill.
class OnFloor {
 public:
  static constexpr double g = 9.81, radius = 0.01, density = 2600, dt = 1e-5;

  struct Start {
    PairProperties pair;
    double slope = 0, speed = 0, angular_velocity = 0;  ///< [rad], along x [m/s], forward about y [rad/s]
  };

  OnFloor(const Start& start, Precision precision) : stage_(scene(start), precision) {
    const double weight = sphere_mass(radius, density) * g * std::cos(start.slope);
    const double deep = static_overlap(youngs_against_rigid(rock()), radius, weight);
    stage_.insert(
        {sphere(0, {0, 0, radius - deep}, {start.speed, 0, 0}, radius, density, {0, start.angular_velocity, 0})});
  }

  static Material rock() { return {"rock", density, 557e6, 0.35}; }

  /// Runs up to a time. @return the largest of |v| and R |w| at every fiftieth step on the way [m/s]
  double run_to(double time) {
    double fastest = 0;
    while (stage_.time() < time - 0.5 * dt) {
      const double left = std::round((time - stage_.time()) / dt);
      stage_.advance(left < 50 ? static_cast<int>(left) : 50);
      const ParticleSnapshot s = stage_.dem().particles();
      fastest = std::max({fastest, norm(s.velocity[0]), radius * norm(s.angular_velocity[0])});
    }
    return fastest;
  }
  void step() { stage_.advance(1); }
  double time() const { return stage_.time(); }
  double x() { return stage_.dem().particles().position[0].x; }
  double speed() { return stage_.dem().particles().velocity[0].x; }
  double angular_velocity() { return stage_.dem().particles().angular_velocity[0].y; }

 private:
  static Scene scene(const Start& start) {
    Scene scene = scene_of(rock(), rigid(), start.pair, dt);
    scene.gravity = {g * std::sin(start.slope), 0, -g * std::cos(start.slope)};
    scene.walls = {floor_plane()};
    return scene;
  }
  Stage stage_;
};

}  // namespace gyro::verify
