// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/wall_lane.hpp"

namespace gyro {

/// A sphere and one place where it touches a wall. World frame; T is double or a pack.
template <class T>
struct SphereOnWall {
  ParticleRow<T> sphere, motion, angular;
  WallVelocity<T> wall;
  Vec3<T> outward;  ///< unit, from the wall to the sphere
  T overlap;        ///< [m]
  T damping_rate;   ///< of the sphere, as ContactMotion::damping_rate [1/s]

  GYRO_HD T arm() const { return sphere.number - overlap; }  ///< from the centre to the wall [m]
  GYRO_HD Vec3<T> point() const { return sphere.vector - arm() * outward; }

  /// What the contact law reads.
  /// @param wall_velocity  of the wall at the point [m/s]
  template <class Real>
  GYRO_HD auto contact(const Vec3<T>& wall_velocity) const {
    ContactMotion<decltype(lane_cast<Real>(overlap))> c;
    c.normal = lane_cast<Real>(-outward);
    c.overlap = lane_cast<Real>(overlap);
    c.velocity = lane_cast<Real>(motion.vector - wall_velocity - arm() * cross(angular.vector, outward));
    c.angular_velocity = lane_cast<Real>(angular.vector - wall.angular_velocity);
    c.radius = lane_cast<Real>(sphere.number);
    c.mass = lane_cast<Real>(motion.number);
    c.inertia = lane_cast<Real>(angular.number);
    c.lever = lane_cast<Real>(arm());
    c.damping_rate = lane_cast<Real>(damping_rate);
    return c;
  }
};

/// What the contacts of an entry do to the particle and to the wall.
template <class T, class Real>
struct WallLoads {
  WallResult<Real> result{};
  WallTotal<T> total;

  /// Adds one contact.
  /// @param weight  its share
  GYRO_HD void add(const ContactLoad<Real>& load, const Real& weight, const ContactMotion<Real>& c,
                   const SphereOnWall<T>& at, const Vec3<T>& wall_velocity) {
    const Vec3<Real> force = weight * load.force;
    const Vec3<Real> couple = weight * load.couple;
    result.force += force;
    result.torque += c.lever * cross(c.normal, force) + couple;
    result.damped = result.damped + weight * load.damped;
    result.slipped = result.slipped + weight * load.slipped;
    result.dashpot = result.dashpot + weight * load.dashpot;
    total.add(lane_cast<double>(force), at.point(), wall_velocity);
    total.add_couple(lane_cast<double>(couple), at.wall.angular_velocity);
  }
};

}  // namespace gyro
