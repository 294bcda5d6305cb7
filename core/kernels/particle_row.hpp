// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state/particles.hpp"

namespace gyro {

/// What a row of a particle holds, of one particle or of a pack of them: position and radius, velocity and mass, or
/// angular velocity and moment of inertia.
template <class T>
struct ParticleRow {
  Vec3<T> vector;
  T number;
};

GYRO_HD inline ParticleRow<double> row_of(const Sphere& s) {
  return {s.x, s.radius};
}
GYRO_HD inline ParticleRow<double> row_of(const Motion& m) {
  return {m.v, m.mass};
}
GYRO_HD inline ParticleRow<double> row_of(const AngularMotion& a) {
  return {a.w, a.inertia};
}

/// Lanes of a pack: doubles in a vector register of the processor, 4 to 8. With more, the state of a bond or contact
/// does not stay in registers (core/README.md). Results do not depend on it.
#if defined(__AVX512F__)
inline constexpr int native_lanes = 8;
#else
inline constexpr int native_lanes = 4;
#endif
/// Lanes of a pack of contacts whose loads are Real: twice as many numbers where they are half as long and registers
/// are short. Rows are read and written in packs of 4 and of 8.
template <class Real>
inline constexpr int load_lanes = sizeof(Real) == 4 ? 8 : native_lanes;

}  // namespace gyro
