// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state/walls.hpp"

namespace gyro {

/// A number of quanta. Numbers that are not finite count as zero here: the guard reports the particle.
GYRO_HD inline std::int64_t quanta(double x) {
  constexpr double maximum = 9e18;
  return x > -maximum && x < maximum ? static_cast<std::int64_t>(::floor(x + 0.5)) : 0;
}
template <class T>
GYRO_HD auto quanta(const Vec3<T>& v) {
  return Vec3<decltype(quanta(v.x))>{quanta(v.x), quanta(v.y), quanta(v.z)};
}

/// What is booked at once, of one entry or of a pack of them: as WallSum.
template <class Int>
struct WallQuanta {
  Vec3<Int> force, torque;
  Int work, slip;
};

/// What the contacts of one entry do to the wall. T is double or a pack.
template <class T>
struct WallTotal {
  Vec3<T> force{T(0), T(0), T(0)};   ///< on the particle [N]
  Vec3<T> torque{T(0), T(0), T(0)};  ///< about the world's origin [N m]
  T power = T(0);                    ///< of the wall on the particle [W]
  T slip_power = T(0);               ///< lost in sliding friction [W]

  GYRO_HD void add(const Vec3<T>& on_particle, const Vec3<T>& point, const Vec3<T>& wall_velocity) {
    force += on_particle;
    torque += cross(point, on_particle);
    power = power + dot(on_particle, wall_velocity);
  }
  GYRO_HD void add_couple(const Vec3<T>& on_particle, const Vec3<T>& wall_spin) {
    torque += on_particle;
    power = power + dot(on_particle, wall_spin);
  }
  /// What acts over a time [s], to be added to an exact sum.
  GYRO_HD auto over(const T& time) const {
    const T scale = time / T(wall_quantum);
    using Int = decltype(quanta(scale));
    return WallQuanta<Int>{-quanta(scale * force), -quanta(scale * torque), quanta(scale * power),
                           quanta(scale * slip_power)};
  }
};

}  // namespace gyro
