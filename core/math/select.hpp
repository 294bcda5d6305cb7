// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

// Branch-free choices, so that one text of a law serves single numbers and packs.

namespace gyro {

GYRO_HD constexpr float select(bool choose, float a, float b) {
  return choose ? a : b;
}
GYRO_HD constexpr double select(bool choose, double a, double b) {
  return choose ? a : b;
}

/// A number, or each number of a vector, in another number type. For packs see core/math/pack.hpp.
template <class To>
GYRO_HD constexpr To lane_cast(float a) {
  return static_cast<To>(a);
}
template <class To>
GYRO_HD constexpr To lane_cast(double a) {
  return static_cast<To>(a);
}
template <class To, class From>
GYRO_HD constexpr auto lane_cast(const Vec3<From>& a) {
  return Vec3<decltype(lane_cast<To>(a.x))>{lane_cast<To>(a.x), lane_cast<To>(a.y), lane_cast<To>(a.z)};
}

/// The same choice for all three components.
template <class Mask, class T>
GYRO_HD Vec3<T> select(const Mask& choose, const Vec3<T>& a, const Vec3<T>& b) {
  return {select(choose, a.x, b.x), select(choose, a.y, b.y), select(choose, a.z, b.z)};
}

template <class T>
GYRO_HD T larger(const T& a, const T& b) {
  return select(a > b, a, b);
}
template <class T>
GYRO_HD T smaller(const T& a, const T& b) {
  return select(a < b, a, b);
}
template <class T>
GYRO_HD T positive(const T& a) {
  return larger(a, T(0));
}
template <class T>
GYRO_HD T magnitude(const T& a) {
  return select(a < T(0), -a, a);
}

}  // namespace gyro
