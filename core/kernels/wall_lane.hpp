// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/row_lane.hpp"
#include "core/kernels/wall_total.hpp"
#include "core/laws/contact/contact.hpp"

// Lanes of the kernel of walls, as those of pairs in pair_lane.hpp: OneEntry is one entry of the wall list,
// PackOfEntries (wall_pack.hpp) is N of them.

namespace gyro {

/// How walls move, of one entry or of a pack of them.
template <class T>
struct WallVelocity {
  Vec3<T> origin;            ///< of the body [m]
  Vec3<T> velocity;          ///< of the origin [m/s]
  Vec3<T> angular_velocity;  ///< [rad/s]

  /// Of the wall's material at a world point, as velocity_at() [m/s].
  GYRO_HD Vec3<T> at(const Vec3<T>& point) const { return velocity + cross(angular_velocity, point - origin); }
};

GYRO_HD inline ParticleRow<double> row_of(const WallTouchNow& t) {
  return {t.outward, t.overlap};
}

/// One entry.
struct OneEntry : OneRow {
  template <class Row>
  GYRO_HD ParticleRow<double> own_row(const Row* rows) const {
    return row_of(rows[n]);
  }
  GYRO_HD WallVelocity<double> velocity(const WallPose* poses, Index wall) const {
    return {poses[wall].origin, poses[wall].velocity, poses[wall].angular_velocity};
  }
  template <class Real>
  GYRO_HD const ContactConstants<Real>& of_wall(const ContactConstants<Real>* constants, Index wall) const {
    return constants[wall];
  }

  /// The first contact of an entry.
  template <class Real>
  GYRO_HD WallContact<Real> first(const WallHistory<Real>* history) const {
    return history[n].contact[0];
  }
  template <class Real>
  GYRO_HD void store_first(WallHistory<Real>* history, const WallContact<Real>& contact) const {
    history[n].contact[0] = contact;
  }
  GYRO_HD void add(WallSum* sums, const WallQuanta<std::int64_t>& q) const {
    sums[n] = sums[n] + WallSum{q.force, q.torque, q.work, q.slip};
  }
};

template <int N>
struct PackOfEntries;

}  // namespace gyro
