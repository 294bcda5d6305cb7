// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/row_pack.hpp"
#include "core/kernels/wall_lane.hpp"

namespace gyro {

template <int N>
Pack<std::int64_t, N> quanta(const Pack<double, N>& x) {
  using P = Pack<double, N>;
  const P maximum(9e18);
  return pack_cast<std::int64_t>(floor(select((x > -maximum) & (x < maximum), x + P(0.5), P(0))));
}

/// N entries.
template <int N>
struct PackOfEntries : PackOfRows<N> {
  using PackOfRows<N>::n;

  template <class Row>
  ParticleRow<Pack<double, N>> own_row(const Row* rows) const {
    return row_columns<double, N>([&](int k) { return whole_row(rows, n[k]); });
  }
  WallVelocity<Pack<double, N>> velocity(const WallPose* poses, const RowNumbers<N>& wall) const {
    const auto columns = [&](Vec3d WallPose::*member) {
      return struct_columns<N>(&(poses->*member), [&](int k) { return &(poses[wall.v[k]].*member); });
    };
    return {columns(&WallPose::origin), columns(&WallPose::velocity), columns(&WallPose::angular_velocity)};
  }
  template <class Real>
  ContactConstants<Pack<Real, N>> of_wall(const ContactConstants<Real>* constants, const RowNumbers<N>& wall) const {
    return struct_columns<N>(constants, [&](int k) { return constants + wall.v[k]; });
  }

  template <class Real>
  WallContact<Pack<Real, N>> first(const WallHistory<Real>* history) const {
    return struct_columns<N>(history->contact, [&](int k) { return history[n[k]].contact; });
  }
  template <class Real>
  void store_first(WallHistory<Real>* history, const WallContact<Pack<Real, N>>& contact) const {
    store_structs<N, WallContact, Real>(contact, [&](int k) { return history[n[k]].contact; });
  }
  void add(WallSum* sums, const WallQuanta<Pack<std::int64_t, N>>& q) const {
    constexpr int numbers = sizeof(WallSum) / sizeof(std::int64_t);
    static_assert(sizeof q == numbers * sizeof q.work);
    alignas(64) std::int64_t lanes[numbers][N];
    std::memcpy(lanes, static_cast<const void*>(&q), sizeof lanes);
    for (int k = 0; k < N; ++k) {
      WallSum& sum = sums[n[k]];
      sum = sum + WallSum{{lanes[0][k], lanes[1][k], lanes[2][k]},
                          {lanes[3][k], lanes[4][k], lanes[5][k]},
                          lanes[6][k],
                          lanes[7][k]};
    }
  }
};

}  // namespace gyro
