// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/bond_lane.hpp"
#include "core/kernels/row_columns.hpp"

namespace gyro {

/// N neighbouring bonds from any `first` on. The loads are computed together and added to the
/// particles' rows one bond after the other. N is 4 or 8.
template <int N>
struct PackLanes {
  template <class T>
  using Number = Pack<T, N>;
  static constexpr int count = N;
  Index first;

  template <class T>
  Pack<T, N> load(const T* column) const {
    Pack<T, N> out;
    std::memcpy(&out.v, column + first, sizeof out.v);
    return out;
  }

  /// The vector of a row, in the number type T.
  template <class T, class Row>
  Vec3<Pack<T, N>> vector(const Row* rows, const Pack<Index, N>& row) const {
    return row_columns<T, N>([&](int k) { return whole_row(rows, row.v[k]); }).vector;
  }
  /// The vector of row a less that of row b, subtracted in double, in the number type T.
  template <class T, class Row>
  Vec3<Pack<T, N>> difference(const Row* rows, const Pack<Index, N>& a, const Pack<Index, N>& b) const {
    return row_columns<T, N>([&](int k) { return whole_row(rows, a.v[k]) - whole_row(rows, b.v[k]); }).vector;
  }
  Quat<Pack<double, N>> quaternion(const Quatd* rows, const Pack<Index, N>& row) const {
    const auto c = row_columns<double, N>([&](int k) { return whole_row(rows, row.v[k]); });
    return {c.vector.x, c.vector.y, c.vector.z, c.number};
  }

  template <class Real>
  BondConstants<Pack<Real, N>> spread(const BondConstants<Real>& law) const {
    return gyro::cast<Pack<Real, N>>(law);
  }

  template <class Real>
  PackMask<Real, N> is_intact(const Pack<std::int32_t, N>& state) const {
    const Pack<Real, N> number = pack_cast<Real>(state);
    return {number.v == Pack<Real, N>(static_cast<Real>(bond_intact)).v};
  }
  bool any_unbroken(const Pack<std::int32_t, N>& state) const {
    return any_bit(state.v < Pack<std::int32_t, N>(bond_broken).v);
  }
  bool any_pressed(const Pack<std::int32_t, N>& state) const {
    return any_bit(state.v == Pack<std::int32_t, N>(bond_pressed).v);
  }
  template <class T>
  bool any(const PackMask<T, N>& m) const {
    return any_bit(m.v);
  }
  template <class T>
  bool test(const PackMask<T, N>& m, int lane) const {
    return m[lane];
  }
  Index index(int lane) const { return first + lane; }
  template <class T>
  T value(const Pack<T, N>& x, int lane) const {
    return x[lane];
  }

  template <class Real>
  void add(Load* rows, const Pack<Index, N>& i, const Pack<Index, N>& j, const Pack<std::int32_t, N>& state,
           const BondLoad<Pack<Real, N>>& load, const Pack<Real, N>& slip_work) const {
    using Rows = RowsOfFour<Real, N>;
    const Pack<Real, N> zero(0);
    const Rows forces_i(-load.force.x, -load.force.y, -load.force.z, load.damped),
        torques_i(load.torque_i.x, load.torque_i.y, load.torque_i.z, slip_work);
    const Rows forces_j(load.force.x, load.force.y, load.force.z, zero),
        torques_j(load.torque_j.x, load.torque_j.y, load.torque_j.z, zero);
    for_lanes<N>([&](int k) {
      if (state.v[k] == bond_broken) return;
      add_row<Real>(rows[i.v[k]], forces_i.row[k], torques_i.row[k]);
      add_row<Real>(rows[j.v[k]], forces_j.row[k], torques_j.row[k]);
    });
  }

 private:
  /// Load is a row of eight doubles: force, damped, torque, slipped.
  template <class Real>
  static void add_row(Load& load, const Four<Real>& force, const Four<Real>& torque) {
    static_assert(sizeof(Load) == 2 * sizeof(Four<double>));
    Four<double> sum[2];
    std::memcpy(sum, &load, sizeof sum);
    sum[0] += pack_cast<double>(Pack<Real, 4>{force}).v;
    sum[1] += pack_cast<double>(Pack<Real, 4>{torque}).v;
    std::memcpy(static_cast<void*>(&load), sum, sizeof sum);
  }
};

}  // namespace gyro
