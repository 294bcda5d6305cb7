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
