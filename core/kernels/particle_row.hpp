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

/// Lanes of a pack of bonds or contacts whose loads are Real. A register of AVX2 holds four doubles or eight single
/// numbers: single loads are computed for eight, what needs double precision for four at a time.
template <class Real>
#if defined(__AVX__) && !defined(__AVX512F__)
inline constexpr int load_lanes = sizeof(Real) == 4 ? 2 * native_lanes : native_lanes;
#else
inline constexpr int load_lanes = native_lanes;
#endif

}  // namespace gyro
