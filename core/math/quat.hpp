// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

namespace gyro {

/// Unit quaternion w + xi + yj + zk: the rotation from a body's frame to the world.
template <class T>
struct Quat {
  T w, x, y, z;
};

template <class T>
struct RowOf<Quat<T>> : MadeOf<T> {};

using Quatd = Quat<double>;

template <class T>
GYRO_HD constexpr Quat<T> operator*(const Quat<T>& a, const Quat<T>& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
template <class T>
GYRO_HD constexpr Quat<T> conjugate(const Quat<T>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
template <class T>
GYRO_HD Quat<T> normalised(const Quat<T>& q) {
  using std::sqrt;
  const T s = T(1) / sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// v turned by q, for a unit q: v + 2 r x (r x v + w v) with r the vector part.
template <class T>
GYRO_HD constexpr Vec3<T> rotate(const Quat<T>& q, const Vec3<T>& v) {
  const Vec3<T> r{q.x, q.y, q.z};
  const Vec3<T> c = cross(r, v) + q.w * v;
  const Vec3<T> t = cross(r, c);
  return {v.x + (t.x + t.x), v.y + (t.y + t.y), v.z + (t.z + t.z)};
}

/// v turned back by q: from the world to the body's frame.
template <class T>
GYRO_HD constexpr Vec3<T> rotate_back(const Quat<T>& q, const Vec3<T>& v) {
  return rotate(conjugate(q), v);
}

/// q brought back to unit length, for a q that is nearly so: two Newton steps of 1/sqrt from 1, exact to
/// 35/128 (|q|^2 - 1)^4 and without division or root.
template <class T>
GYRO_HD constexpr Quat<T> renormalised(const Quat<T>& q) {
  const T square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
  const T once = T(1.5) - T(0.5) * square;
  const T s = once * (T(1.5) - T(0.5) * square * once * once);
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}

/// Rotates q by the angular velocity w [rad/s, world frame] for a time dt [s], |w| dt < 0.5.
///
/// q' = (1, w dt/2) q at unit length rotates by 2 atan(|w| dt/2): the angle is short by (|w| dt)^2/12, the
/// same for all bodies of one angular velocity; no trigonometry, so that the CPU and the GPU agree to the bit.
template <class T>
GYRO_HD constexpr Quat<T> rotated(const Quat<T>& q, const Vec3<T>& w, T dt) {
  const T h = T(0.5) * dt;
  return renormalised(Quat<T>{T(1), h * w.x, h * w.y, h * w.z} * q);
}

/// Rotation by the angle [rad] about the unit axis (host set-up only: uses sin and cos).
inline Quatd rotation_about(const Vec3d& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

}  // namespace gyro
