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
    const Pack<Real, N> zero(0);
    const Pack<Real, N> at_i[8] = {-load.force.x,   -load.force.y,   -load.force.z,   load.damped,
                                   load.torque_i.x, load.torque_i.y, load.torque_i.z, slip_work};
    const Pack<Real, N> at_j[8] = {load.force.x,    load.force.y,    load.force.z,    zero,
                                   load.torque_j.x, load.torque_j.y, load.torque_j.z, zero};
    alignas(64) Real rows_i[N][8], rows_j[N][8];
    transpose(at_i, rows_i);
    transpose(at_j, rows_j);
    for (int k = 0; k < N; ++k) {
      if (state.v[k] == bond_broken) continue;
      add_row(rows[i.v[k]], rows_i[k]);
      add_row(rows[j.v[k]], rows_j[k]);
    }
  }

 private:
  template <class Real>
  static void transpose(const Pack<Real, N> (&columns)[8], Real (&rows)[N][8]) {
    for (int c = 0; c < 8; ++c)
      for (int k = 0; k < N; ++k) rows[k][c] = columns[c].v[k];
  }
  /// Load is a row of eight doubles: force, damped, torque, slipped.
  template <class Real>
  static void add_row(Load& load, const Real (&row)[8]) {
    static_assert(sizeof(Load) == 8 * sizeof(double));
    Pack<double, 8> sum;
    Pack<Real, 8> more;
    std::memcpy(&sum.v, &load, sizeof sum.v);
    std::memcpy(&more.v, row, sizeof more.v);
    sum = sum + pack_cast<double>(more);
    std::memcpy(static_cast<void*>(&load), &sum.v, sizeof sum.v);
  }
};

}  // namespace gyro
