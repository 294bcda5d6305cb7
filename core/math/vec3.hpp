// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/base/hd.hpp"

#include <cmath>

namespace gyro {

/// Three components in a right-handed frame. T is float, double or a pack of them.
template <class T>
struct Vec3 {
  T x, y, z;
};

template <class T>
struct RowOf<Vec3<T>> : MadeOf<T> {};

using Vec3d = Vec3<double>;
using Vec3f = Vec3<float>;

template <class T>
GYRO_HD constexpr Vec3<T> operator+(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
GYRO_HD constexpr Vec3<T> operator-(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
GYRO_HD constexpr Vec3<T> operator-(const Vec3<T>& a) {
  return {-a.x, -a.y, -a.z};
}
template <class T>
GYRO_HD constexpr Vec3<T> operator*(const T& s, const Vec3<T>& a) {
  return {s * a.x, s * a.y, s * a.z};
}
template <class T>
GYRO_HD constexpr Vec3<T>& operator+=(Vec3<T>& a, const Vec3<T>& b) {
  return a = a + b;
}
template <class T>
GYRO_HD constexpr Vec3<T>& operator-=(Vec3<T>& a, const Vec3<T>& b) {
  return a = a - b;
}
template <class T>
GYRO_HD constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
GYRO_HD constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T>
GYRO_HD constexpr T norm2(const Vec3<T>& a) {
  return dot(a, a);
}
template <class T>
GYRO_HD T norm(const Vec3<T>& a) {
  using std::sqrt;
  return sqrt(norm2(a));
}

/// Part of a that lies in the plane with unit normal n.
template <class T>
GYRO_HD constexpr Vec3<T> tangential(const Vec3<T>& a, const Vec3<T>& n) {
  return a - dot(a, n) * n;
}

/// The same vector in another number type.
template <class To, class From>
GYRO_HD constexpr Vec3<To> cast(const Vec3<From>& a) {
  return {static_cast<To>(a.x), static_cast<To>(a.y), static_cast<To>(a.z)};
}

}  // namespace gyro
