// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"
#include "core/scene/window.hpp"

namespace gyro {

/// The eccentric at one instant. Angles grow without bound, they are not wrapped to 2 pi.
struct MantleState {
  double angle = 0;       ///< eccentric angle theta: azimuth where the mantle is nearest [rad]
  double speed = 0;       ///< theta' [rad/s]
  double spin_angle = 0;  ///< integral of sigma over time [rad]
  double spin = 0;        ///< sigma, of the mantle about its own axis [rad/s]
};

/// The eccentric a time after the begin of a window.
GYRO_HD inline MantleState mantle_at(const MantlePath& path, double since_begin) {
  return {path.angle + path.speed * since_begin, path.speed, path.spin_angle + path.spin * since_begin, path.spin};
}

/// The mantle's axis, pointing up: u = (-sin b cos theta, -sin b sin theta, cos b), sin b = e0 / Lp.
Vec3d mantle_axis(const GyrationMotion& motion, double angle);

/// Pose of a gyrating body, exact from the angles, never integrated.
///
///   orientation = Rz(theta) Ry(-b) Rz(psi - theta cos b),  psi = spin_angle
///               = (least rotation z -> u) Rz(psi + theta (1 - cos b))
///   angular_velocity = theta' (z - cos b u) + sigma u
///   origin = (0, 0, Lp) + (lift - Lp) u,  velocity = angular_velocity x (origin - pivot)
///
/// sigma is the spin about the own axis against a frame that follows u without rotating about it.
/// Such a frame does not come back after a gyration, it has turned by the solid angle
/// 2 pi (1 - cos b) of u's cone: hence the term theta (1 - cos b). Locked to the eccentric:
/// sigma = theta' cos b, angular_velocity = theta' z. The test differentiates the pose.
WallPose gyration_pose(const GyrationMotion& motion, const MantleState& mantle);

/// Pose of a wall.
/// @param time    since the start of the run [s]
/// @param mantle  the eccentric at that time; only GyrationMotion uses it
WallPose pose_of(const Wall& wall, double time, const MantleState& mantle);

/// Upper bound on the speed at which a wall's surface sweeps through space [m/s]. A surface of revolution that
/// spins about its own axis stays where it is. 0 for planes: behind them all is wall, so that none is passed unseen.
/// @param extent  largest distance of the surface from the body's origin [m]
double sweep_speed(const Wall& wall, double extent, const WallPose& pose);
/// Largest distance of a wall's surface from the body's origin, 0 for a plane [m].
double extent_of(const Wall& wall);

/// Throws BadInput when a motion's numbers make no sense (axis not unit, radius negative, ...).
void check_motion(const Wall& wall);

/// Into a wall's frame and back.
GYRO_HD inline Vec3d to_body(const WallPose& pose, const Vec3d& world) {
  return rotate_back(pose.orientation, world - pose.origin);
}
GYRO_HD inline Vec3d to_world(const WallPose& pose, const Vec3d& body) {
  return pose.origin + rotate(pose.orientation, body);
}
/// Velocity of the wall's material at a world point [m/s].
GYRO_HD inline Vec3d velocity_at(const WallPose& pose, const Vec3d& world) {
  return pose.velocity + cross(pose.angular_velocity, world - pose.origin);
}

}  // namespace gyro
