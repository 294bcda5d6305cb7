// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/wall_motion.hpp"

#include "core/base/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

constexpr Vec3d up{0, 0, 1};

WallPose pose(const Fixed&, double, const MantleState&) {
  return {};
}

WallPose pose(const LinearMotion& m, double time, const MantleState&) {
  WallPose p;
  p.origin = time * m.velocity;
  p.velocity = m.velocity;
  return p;
}

WallPose pose(const RotationMotion& m, double time, const MantleState&) {
  WallPose p;
  p.orientation = rotation_about(m.axis, m.speed * time);
  p.origin = m.point - rotate(p.orientation, m.point);
  p.angular_velocity = m.speed * m.axis;
  p.velocity = cross(p.angular_velocity, p.origin - m.point);
  return p;
}

WallPose pose(const CircularMotion& m, double time, const MantleState&) {
  // The phase is reduced before it is turned into an angle, so that whole periods return exactly.
  const double turns = std::fmod(time / m.period, 1.0);
  const double speed = 2 * std::numbers::pi / m.period, angle = 2 * std::numbers::pi * turns;
  const double s = std::sin(angle), c = std::cos(angle), half = std::sin(angle / 2);
  WallPose p;
  p.origin = {m.radius * s, 2 * m.radius * half * half, 0};
  p.velocity = {m.radius * speed * c, m.radius * speed * s, 0};
  return p;
}

WallPose pose(const GyrationMotion& m, double, const MantleState& mantle) {
  return gyration_pose(m, mantle);
}

void require(bool good, const Wall& wall, const char* problem) {
  if (!good) throw BadInput("wall '" + wall.name + "': " + problem);
}

bool finite(const Vec3d& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

struct MotionCheck {
  const Wall& wall;
  void operator()(const Fixed&) const {}
  void operator()(const LinearMotion& m) const {
    require(finite(m.velocity), wall, "the linear velocity is not finite; give three numbers in m/s");
  }
  void operator()(const RotationMotion& m) const {
    require(finite(m.axis) && std::abs(norm(m.axis) - 1) < 1e-9, wall,
            "the axis of rotation has no length; give a direction that is not zero");
    require(finite(m.point) && std::isfinite(m.speed), wall,
            "the rotation is not finite; give a point and a speed in rad/s");
  }
  void operator()(const CircularMotion& m) const {
    require(m.radius >= 0 && std::isfinite(m.radius), wall, "the radius of the circle is negative; it must be >= 0");
    require(m.period > 0 && std::isfinite(m.period), wall, "the period of the circle is not positive; it must be > 0");
  }
  void operator()(const GyrationMotion& m) const {
    require(m.pivot_height > 0 && std::isfinite(m.pivot_height), wall,
            "the pivot is not above the discharge plane; pivot_height must be > 0");
    require(m.eccentricity >= 0 && m.eccentricity < m.pivot_height, wall,
            "the eccentricity is out of range; it must be >= 0 and < pivot_height");
    require(std::isfinite(m.lift), wall, "the lift is not finite; give a length");
  }
};

}  // namespace

Vec3d mantle_axis(const GyrationMotion& motion, double angle) {
  const double sin_tilt = motion.eccentricity / motion.pivot_height;
  const double cos_tilt = std::sqrt((1 - sin_tilt) * (1 + sin_tilt));
  return {-sin_tilt * std::cos(angle), -sin_tilt * std::sin(angle), cos_tilt};
}

WallPose gyration_pose(const GyrationMotion& motion, const MantleState& mantle) {
  const double sin_tilt = motion.eccentricity / motion.pivot_height;
  const Vec3d axis = mantle_axis(motion, mantle.angle);
  // Least rotation z -> u: half-angle quaternion (1 + cos b, z x u), normalised.
  const Quatd tilt = normalised(Quatd{1 + axis.z, -axis.y, axis.x, 0});
  const double drift = sin_tilt * sin_tilt / (1 + axis.z);  // 1 - cos b
  const double own_turn = mantle.spin_angle + mantle.angle * drift;

  WallPose p;
  p.orientation = tilt * rotation_about(up, own_turn);
  p.origin = Vec3d{0, 0, motion.pivot_height} + (motion.lift - motion.pivot_height) * axis;
  p.angular_velocity = mantle.speed * (up - axis.z * axis) + mantle.spin * axis;
  p.velocity = cross(p.angular_velocity, (motion.lift - motion.pivot_height) * axis);
  return p;
}

WallPose pose_of(const Wall& wall, double time, const MantleState& mantle) {
  return std::visit([&](const auto& motion) { return pose(motion, time, mantle); }, wall.motion);
}

double sweep_speed(const Wall& wall, double extent, const WallPose& pose) {
  if (std::holds_alternative<PlaneShape>(wall.shape)) return 0;
  Vec3d spin = pose.angular_velocity;
  if (std::holds_alternative<ProfileShape>(wall.shape)) {
    const Vec3d axis = rotate(pose.orientation, up);
    spin = spin - dot(spin, axis) * axis;
  }
  return norm(pose.velocity) + norm(spin) * extent;
}

double extent_of(const Wall& wall) {
  double extent2 = 0;
  if (const auto* profile = std::get_if<ProfileShape>(&wall.shape))
    for (const ProfilePoint& p : profile->points) extent2 = std::max(extent2, p.r * p.r + p.z * p.z);
  if (const auto* mesh = std::get_if<TriangleMesh>(&wall.shape))
    for (const Vec3d& v : mesh->vertices) extent2 = std::max(extent2, norm2(v));
  return std::sqrt(extent2);
}

void check_motion(const Wall& wall) {
  std::visit(MotionCheck{wall}, wall.motion);
}

}  // namespace gyro
