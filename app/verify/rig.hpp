// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/scenes.hpp"

#include <optional>

namespace gyro::verify {

/// A rig that leads a wall along a path against rock that is held: a gyrating cylinder of 1 m radius. Its
/// eccentric angle, near a right angle, moves its surface along x (eccentricity x cos), its own spin along y.
class Rig {
 public:
  /// @param rock      its contact with the cylinder is at `place`
  /// @param dt        [s]
  Rig(const Material& material, const PairProperties& pair, double dt, const NewRock& rock, Precision precision,
      const std::optional<BondParameters>& bonds = {});

  /// The cylinder's surface, where it first meets the rock. Its outward normal there is x.
  static constexpr Vec3d place{1, 0.02, 0};

  /// Moves the surface by steps of equal size. @param press, shear  along x and y [m]
  void move(double press, double shear, int steps);

  /// On the first particle of the rock, by its contacts and bonds, now [N].
  Vec3d force() const { return stage_.dem().particles().force[0]; }
  ParticleSnapshot particles() const { return stage_.dem().particles(); }
  double work() const { return work_; }  ///< that the wall has done on the rock [J]

 private:
  mutable Stage stage_;
  double press_ = 0, shear_ = 0, work_ = 0;
};

/// So heavy that no contact moves it.
inline constexpr double held = 1e20;  ///< density [kg/m3]

}  // namespace gyro::verify
