// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/particle_lane.hpp"
#include "core/kernels/row_columns.hpp"

namespace gyro {

/// The columns of the forces and torques of N loads that lie side by side.
template <int N>
ForceAndTorque<Pack<double, N>> load_columns(const Load* rows) {
  static_assert(sizeof(Load) == 8 * sizeof(double));
  using P = Pack<double, N>;
  if constexpr (N == 4) {
    return {row_columns<double, N>([&](int k) { return vector_at<Four<double>>(rows, 2 * k); }).vector,
            row_columns<double, N>([&](int k) { return vector_at<Four<double>>(rows, 2 * k + 1); }).vector};
  } else {
    static_assert(N == 8);
    const auto r = [&](int k) { return vector_at<typename P::Vector>(rows, k); };
    // Of rows k and k + 1: x x z z of the force, then of the torque; the same of y.
    const auto xz = [&](int k) { return __builtin_shufflevector(r(k), r(k + 1), 0, 8, 2, 10, 4, 12, 6, 14); };
    const auto y = [&](int k) { return __builtin_shufflevector(r(k), r(k + 1), 1, 9, 1, 9, 5, 13, 5, 13); };
    const auto join_x = [](const auto& a, const auto& b) {
      return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
    };
    const auto join_z = [](const auto& a, const auto& b) {
      return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    };
    const auto force = [](const auto& a, const auto& b) {
      return P{__builtin_shufflevector(a, b, 0, 1, 2, 3, 8, 9, 10, 11)};
    };
    const auto torque = [](const auto& a, const auto& b) {
      return P{__builtin_shufflevector(a, b, 4, 5, 6, 7, 12, 13, 14, 15)};
    };
    const auto xz01 = xz(0), xz23 = xz(2), xz45 = xz(4), xz67 = xz(6);
    const auto x03 = join_x(xz01, xz23), x47 = join_x(xz45, xz67), z03 = join_z(xz01, xz23), z47 = join_z(xz45, xz67),
               y03 = join_x(y(0), y(2)), y47 = join_x(y(4), y(6));
    return {{force(x03, x47), force(y03, y47), force(z03, z47)},
            {torque(x03, x47), torque(y03, y47), torque(z03, z47)}};
  }
}

/// The way back; losses become zero.
template <int N>
void store_loads(Load* rows, const ForceAndTorque<Pack<double, N>>& columns) {
  Four<double> force[N], torque[N];
  store_neighbours<N>(force, {columns.force, Pack<double, N>(0)});
  store_neighbours<N>(torque, {columns.torque, Pack<double, N>(0)});
  for_lanes<N>([&](int k) {
    store_vector(rows, 2 * k, force[k]);
    store_vector(rows, 2 * k + 1, torque[k]);
  });
}

}  // namespace gyro
