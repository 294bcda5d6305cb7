// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/quat.hpp"
#include "core/math/select.hpp"

namespace gyro {

/// Shape of a bond in the unloaded rock.
template <class T>
struct BondShape {
  Vec3<T> axis;  ///< e, unit vector i -> j: while intact in the frame in which the turns of both ends are 1,
                 ///< once pressed in the world frame
  T length;      ///< L0 [m]
  T arm;         ///< a_i: the bond's section lies at x_i + a_i d; a_j = 1 - a_i [-]
};

/// Where the two ends of a bond are, now. World frame.
template <class T>
struct BondEnds {
  Vec3<T> span;  ///< d = x_j - x_i [m]
  Quat<T> orientation_i, orientation_j;
};

/// Deformation of a bond. World frame.
template <class T>
struct BondStrain {
  Vec3<T> normal;  ///< n = d/|d|
  T length;        ///< L = |d| [m]
  T stretch;       ///< L - L0 [m]
  T along;         ///< c = e_w . n [-]
  Vec3<T> shear;   ///< gamma = e_w - c n [-]
  T twist;         ///< theta . n [rad]
  Vec3<T> bend;    ///< theta - (theta . n) n [rad]
};

/// The mean turn of a bond's ends, weighted by the arms and not normalised.
template <class T>
GYRO_HD Quat<T> mean_orientation(T arm, const BondEnds<T>& ends) {
  const Quat<T>&p = ends.orientation_i, &q = ends.orientation_j;
  const T a = arm, b = T(1) - arm;
  return {a * p.w + b * q.w, a * p.x + b * q.x, a * p.y + b * q.y, a * p.z + b * q.z};
}

/// v turned by q, for a q of any length: v + 2/|q|^2 r x (r x v + w v).
template <class T>
GYRO_HD Vec3<T> rotate_any(const Quat<T>& q, const Vec3<T>& v) {
  const Vec3<T> r{q.x, q.y, q.z};
  const T two_over_square = T(2) / (q.w * q.w + norm2(r));
  return v + two_over_square * cross(r, cross(r, v) + q.w * v);
}

/// Where the normal of an intact bond's section points now: e turned by the mean turn of the ends.
template <class T>
GYRO_HD Vec3<T> intact_axis(const BondShape<T>& b, const BondEnds<T>& ends) {
  return rotate_any(mean_orientation(b.arm, ends), b.axis);
}

/// Where the axis of a pressed bond points now. Its ends may roll over each other, so that their mean
/// turn means nothing; the axis is kept in the world frame instead and goes along with their mean spin.
/// @param axis  of the last step, world frame
/// @param spin  a_i w_i + a_j w_j [rad/s]
template <class T>
GYRO_HD Vec3<T> pressed_axis(const Vec3<T>& axis, const Vec3<T>& angular_velocity, T dt) {
  return rotate(rotated(Quat<T>{T(1), T(0), T(0), T(0)}, angular_velocity, dt), axis);
}

/// Strains of a bond in total form: from positions and turns alone, without history.
///
///   gamma = e_w - (e_w . n) n        shear angle, from n towards the axis e_w
///   theta = 2 vec(q_j q_i^-1)        relative turn of the ends
///
/// Objective by construction: a rigid turn of both ends turns the vectors and changes no scalar.
/// Valid while the ends' relative turn is small against 1; bonds of rock fail near 5e-3 rad.
/// All strains are small differences of large numbers, so T is the precision of the state
/// (double) even where loads are single; single turns heated a slow free rock by 2 % in 0.1 s.
///
/// Departure: Potyondy & Cundall (2004) add up increments, which needs six numbers of history
/// per bond; the two agree to first order in the strains (core/README.md has the trial).
///
/// @param axis    e_w: intact_axis() or pressed_axis()
/// @param length0 L0 [m]
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

/// The axis that shows `keep` (0..1) of the present shear: what slip leaves behind.
/// @return unit vector, world frame
template <class T>
GYRO_HD Vec3<T> slipped_axis(const BondStrain<T>& s, T keep) {
  using std::sqrt;
  const Vec3<T> axis = magnitude(s.along) * s.normal + keep * s.shear;
  return (T(1) / sqrt(norm2(axis))) * axis;
}

}  // namespace gyro
