// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/math/quat.hpp"

namespace gyro {

/// A rock as one rigid body: its particles keep their places in it. Every rock has one where the scene lets rocks move
/// rigidly; it holds only while Block::rigid is set.
struct Body {
  Vec3d centre;       ///< of mass [m]
  double mass;        ///< [kg]
  Quatd orientation;  ///< since the rock came into the scene
  Quatd frame;        ///< of its load table, in the world, as the rock came in
  Vec3d velocity;     ///< of the centre [m/s]
  Vec3d spin;         ///< angular momentum about the centre, world frame [kg m2/s]
  Vec3d diagonal,
      rest;  ///< xx, yy, zz and xy, yz, zx of the inverse inertia, frame of the rock as it came in [1/(kg m2)]

  template <class F, class... B>
  static constexpr void for_each_field(F&& f, B&... b) {
    f("centre", b.centre...);
    f("mass", b.mass...);
    f("orientation", b.orientation...);
    f("frame", b.frame...);
    f("velocity", b.velocity...);
    f("spin", b.spin...);
    f("diagonal", b.diagonal...);
    f("rest", b.rest...);
  }
};
static_assert(declares_every_field<Body>);

/// A symmetric matrix by its diagonal (xx, yy, zz) and the rest (xy, yz, zx).
struct Symmetric {
  Vec3d diagonal, rest;

  GYRO_HD Vec3d operator*(const Vec3d& v) const {
    return {diagonal.x * v.x + rest.x * v.y + rest.z * v.z, rest.x * v.x + diagonal.y * v.y + rest.y * v.z,
            rest.z * v.x + rest.y * v.y + diagonal.z * v.z};
  }
  /// Adds m (|r|^2 - r r).
  GYRO_HD void add_point(double m, const Vec3d& r) {
    diagonal += m * Vec3d{r.y * r.y + r.z * r.z, r.z * r.z + r.x * r.x, r.x * r.x + r.y * r.y};
    rest += (-m) * Vec3d{r.x * r.y, r.y * r.z, r.z * r.x};
  }
};

/// The inverse of a regular matrix, by cofactors.
GYRO_HD inline Symmetric inverse(const Symmetric& m) {
  const Vec3d &d = m.diagonal, &r = m.rest;
  const Vec3d diagonal{d.y * d.z - r.y * r.y, d.z * d.x - r.z * r.z, d.x * d.y - r.x * r.x};
  const Vec3d rest{r.y * r.z - r.x * d.z, r.z * r.x - r.y * d.x, r.x * r.y - r.z * d.y};
  const double one = 1 / (d.x * diagonal.x + r.x * rest.x + r.z * rest.z);
  return {one * diagonal, one * rest};
}

/// w = Q I^-1 Q^T L [rad/s], Q the orientation.
GYRO_HD inline Vec3d angular_velocity(const Body& body, const Quatd& orientation) {
  const Symmetric inverse_inertia{body.diagonal, body.rest};
  return rotate(orientation, inverse_inertia * rotate_back(orientation, body.spin));
}

/// The orientation halfway between two that are close.
GYRO_HD inline Quatd halfway(const Quatd& a, const Quatd& b) {
  return normalised(Quatd{a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z});
}

/// Rotates a body over a step whose middle has the angular momentum body.spin, by the angular velocity of the middle:
///
///   w = I^-1(Q_m) L,  Q' = Q turned by w dt,  Q_m halfway between Q and Q'          three iterations for w
///
/// The rule of the implicit midpoint for L constant over the step: of second order and, once w is found, reversible, so
/// that the energy of a free body does not drift.
/// @return w [rad/s]
GYRO_HD inline Vec3d turn(Body& body, double dt) {
  const Quatd start = body.orientation;
  Vec3d w = angular_velocity(body, start);
  for (int k = 0; k < 3; ++k) w = angular_velocity(body, halfway(start, rotated(start, w, dt)));
  body.orientation = rotated(start, w, dt);
  return w;
}

/// Where a particle is in its rock.
struct alignas(32) Arm {
  Vec3d arm;      ///< from the centre of mass, frame of the rock as it came into the scene [m]
  double radius;  ///< of the particle [m]

  template <class F, class... A>
  static constexpr void for_each_field(F&& f, A&... a) {
    f("arm", a.arm...);
    f("radius", a.radius...);
  }
};
static_assert(declares_every_field<Arm>);

}  // namespace gyro
