// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

namespace gyro {

/// Dry friction of one bearing: torque = friction radius (idle_force + force of the rock on it). idle_force stands for
/// weight and unbalance, which act without rock. Adding the magnitudes of both is an upper bound for that of their sum.
struct Bearing {
  double friction = 0;    ///< coefficient, >= 0 [-]
  double radius = 0;      ///< of the sliding surface, >= 0 [m]
  double idle_force = 0;  ///< >= 0 [N]

  double torque(double rock_force) const { return friction * radius * (idle_force + rock_force); }
};

/// The bearings that carry the crushing force, from the rock to the frame.
struct Bearings {
  Bearing outer{};       ///< eccentric in the frame: brakes the eccentric
  Bearing inner{};       ///< mantle's shaft in the eccentric: drags the mantle along with the eccentric
  Bearing spider{};      ///< mantle's shaft in the spider, at the pivot: holds the mantle back
  double depth = 0;      ///< of the eccentric's bushings below the pivot, > 0 where there is friction [m]
  double tilt_sine = 0;  ///< sin b = eccentricity / pivot height [-]
};

/// Forces of the rock on the bearings [N].
struct BearingForces {
  double bushing = 0;  ///< eccentric's bushings, inner and outer alike
  double spider = 0;   ///< across the mantle's axis; the piston below carries what acts along it
};

/// Statics of the mantle, hung at the pivot and held by the bushing at -depth u:
///   R = M x u / depth,   bushing = |R|,   spider = |F + R - ((F + R) . u) u|
/// World frame, at one moment. Source: equilibrium of the mantle without its inertia.
/// @param force, torque  of the rock on the mantle [N], about the pivot [N m]
/// @param axis           u, of the mantle, pointing up
inline BearingForces bearing_forces(const Vec3d& force, const Vec3d& torque, const Vec3d& axis, double depth) {
  const Vec3d at_bushing = (1 / depth) * cross(torque, axis);
  const Vec3d rest = force + at_bushing;
  return {norm(at_bushing), norm(rest - dot(rest, axis) * axis)};
}

}  // namespace gyro
