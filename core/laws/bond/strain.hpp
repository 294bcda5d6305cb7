// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/quat.hpp"
#include "core/math/select.hpp"

namespace gyro {

/// Shape of a bond without load.
template <class T>
struct BondShape {
  Vec3<T> axis;  ///< e, unit vector from i to j. Intact: in the frame in which both orientations are the identity.
                 ///< Pressed: in the world frame
  T length;      ///< L0 [m]
  T arm;         ///< a_i: the section of the bond lies at x_i + a_i d; a_j = 1 - a_i [-]
};

/// Position and orientations of the two ends of a bond. World frame.
template <class T>
struct BondEnds {
  Vec3<T> span;                          ///< d = x_j - x_i [m]
  Quat<T> orientation_i, orientation_j;  ///< q_i, q_j
};

/// Deformation of a bond. World frame.
template <class T>
struct BondStrain {
  Vec3<T> normal;  ///< n = d/|d|
  T length;        ///< L = |d| [m]
  T stretch;       ///< L - L0 [m]
  T along;         ///< c = e_w . n [-]
  Vec3<T> shear;   ///< gamma = e_w - c n [-]
  T twist;         ///< theta_n = theta . n [rad]
  Vec3<T> bend;    ///< theta_s = theta - theta_n n [rad]
};

/// Mean orientation of the ends of a bond, a_i q_i + a_j q_j, not normalised.
template <class T>
GYRO_HD Quat<T> mean_orientation(T arm, const BondEnds<T>& ends) {
  const Quat<T>&p = ends.orientation_i, &q = ends.orientation_j;
  const T a = arm, b = T(1) - arm;
  return {a * p.w + b * q.w, a * p.x + b * q.x, a * p.y + b * q.y, a * p.z + b * q.z};
}

/// v rotated by a quaternion q = (w, r) of any length: v + 2/|q|^2 r x (r x v + w v).
template <class T>
GYRO_HD Vec3<T> rotate_any(const Quat<T>& q, const Vec3<T>& v) {
  const Vec3<T> r{q.x, q.y, q.z};
  const T two_over_square = T(2) / (q.w * q.w + norm2(r));
  return v + two_over_square * cross(r, cross(r, v) + q.w * v);
}

/// e_w of an intact bond: its axis e, rotated by the mean orientation of its ends. Unit vector, world frame.
template <class T>
GYRO_HD Vec3<T> intact_axis(const BondShape<T>& b, const BondEnds<T>& ends) {
  return rotate_any(mean_orientation(b.arm, ends), b.axis);
}

/// e_w of a pressed bond: its axis of the last step, rotated by the mean angular velocity of its ends. The ends may
/// roll over each other, so that their mean orientation says nothing about the axis.
/// @param axis              of the last step, world frame
/// @param angular_velocity  a_i w_i + a_j w_j [rad/s]
/// @param dt                [s]
/// @return unit vector, world frame
template <class T>
GYRO_HD Vec3<T> pressed_axis(const Vec3<T>& axis, const Vec3<T>& angular_velocity, T dt) {
  return rotate(rotated(Quat<T>{T(1), T(0), T(0), T(0)}, angular_velocity, dt), axis);
}

/// Strains of a bond in total form: from positions and orientations alone, without history.
///
///   gamma = e_w - (e_w . n) n        shear angle, from n to the axis e_w
///   theta = 2 vec(q_j q_i^-1)        relative rotation of the ends
///
/// Objective: a rigid rotation of both ends rotates the vectors and leaves the scalars unchanged. Valid while the
/// relative rotation of the ends is small compared with 1 rad; bonds of rock fail near 5e-3 rad. Strains are small
/// differences of large numbers, so T is the precision of the state, double even where loads are single: with single
/// orientations a slowly rotating free rock gained 2 % of its kinetic energy in 0.1 s.
///
/// Departure: Potyondy & Cundall (2004) add up increments, which needs six numbers of history per bond. The two agree
/// to first order in the strains (core/README.md has the trial).
///
/// @param axis     e_w: intact_axis() or pressed_axis()
/// @param length0  L0 [m]
template <class T>
GYRO_HD BondStrain<T> strain_about(const Vec3<T>& axis, T length0, const BondEnds<T>& ends) {
  const T length = norm(ends.span);
  const Vec3<T> n = (T(1) / length) * ends.span;
  const T along = dot(axis, n);

  const Quat<T>&p = ends.orientation_i, &q = ends.orientation_j;
  const Vec3<T> rp{p.x, p.y, p.z}, rq{q.x, q.y, q.z};
  const Vec3<T> half = p.w * rq - q.w * rp + cross(rp, rq);
  const Vec3<T> theta = half + half;
  const T twist = dot(theta, n);
  return {n, length, length - length0, along, axis - along * n, twist, theta - twist * n};
}

/// Strains of an intact bond.
template <class T>
GYRO_HD BondStrain<T> bond_strain(const BondShape<T>& b, const BondEnds<T>& ends) {
  return strain_about(intact_axis(b, ends), b.length, ends);
}

/// Axis of a bond whose shear strain is `keep` times the present one: the axis after slip.
/// @param keep  in [0, 1] [-]
/// @return unit vector, world frame
template <class T>
GYRO_HD Vec3<T> slipped_axis(const BondStrain<T>& s, T keep) {
  using std::sqrt;
  const Vec3<T> axis = magnitude(s.along) * s.normal + keep * s.shear;
  return (T(1) / sqrt(norm2(axis))) * axis;
}

}  // namespace gyro
