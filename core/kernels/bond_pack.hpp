// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/bond_lane.hpp"
#include "core/math/pack.hpp"

#include <array>

namespace gyro {

/// N neighbouring bonds, `first` a multiple of N. The loads are computed together and added to the
/// particles' rows one bond after the other.
///
/// N = 8 because the strains are double: one 512-bit register. With 16 the doubles take two and the
/// trial ran 30 % slower (core/README.md).
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

  Vec3<Pack<double, N>> vector(const Sphere* rows, const Pack<Index, N>& row) const { return first_three(rows, row); }
  Vec3<Pack<double, N>> vector(const Motion* rows, const Pack<Index, N>& row) const { return first_three(rows, row); }
  Vec3<Pack<double, N>> vector(const AngularMotion* rows, const Pack<Index, N>& row) const {
    return first_three(rows, row);
  }
  Quat<Pack<double, N>> quaternion(const Quatd* rows, const Pack<Index, N>& row) const {
    const FourPacks p = gather_rows(rows, row);
    return {p[0], p[1], p[2], p[3]};
  }

  template <class To, class From>
  Pack<To, N> cast(const Pack<From, N>& x) const {
    return pack_cast<To>(x);
  }
  template <class To, class From>
  Vec3<Pack<To, N>> cast(const Vec3<Pack<From, N>>& x) const {
    return pack_cast<To>(x);
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
  using FourPacks = std::array<Pack<double, N>, 4>;

  /// The four doubles of N rows, one pack for each column. Rows are loaded whole and transposed in registers: half the
  /// instructions of a gather number by number.
  template <class Row>
  static FourPacks gather_rows(const Row* rows, const Pack<Index, N>& row) {
    static_assert(sizeof(Row) == 4 * sizeof(double) && N == 8);
    using Four = typename VectorOf<double, 4>::type;
    const auto whole = [&](int k) {
      Four v;
      std::memcpy(&v, rows + row.v[k], sizeof v);
      return v;
    };
    // Rows k and k + 4 side by side, then the same columns interleaved: x0 x1 z0 z1 | x4 x5 z4 z5.
    const auto join = [&](int k) { return __builtin_shufflevector(whole(k), whole(k + 4), 0, 1, 2, 3, 4, 5, 6, 7); };
    const auto r0 = join(0), r1 = join(1), r2 = join(2), r3 = join(3);
    const auto xz01 = __builtin_shufflevector(r0, r1, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto yw01 = __builtin_shufflevector(r0, r1, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto xz23 = __builtin_shufflevector(r2, r3, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto yw23 = __builtin_shufflevector(r2, r3, 1, 9, 3, 11, 5, 13, 7, 15);
    using P = Pack<double, N>;
    return {P{__builtin_shufflevector(xz01, xz23, 0, 1, 8, 9, 4, 5, 12, 13)},
            P{__builtin_shufflevector(yw01, yw23, 0, 1, 8, 9, 4, 5, 12, 13)},
            P{__builtin_shufflevector(xz01, xz23, 2, 3, 10, 11, 6, 7, 14, 15)},
            P{__builtin_shufflevector(yw01, yw23, 2, 3, 10, 11, 6, 7, 14, 15)}};
  }
  template <class Row>
  static Vec3<Pack<double, N>> first_three(const Row* rows, const Pack<Index, N>& row) {
    const FourPacks p = gather_rows(rows, row);
    return {p[0], p[1], p[2]};
  }

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
  template <class Vector>
  static bool any_bit(const Vector& v) {
    std::uint64_t words[sizeof(Vector) / 8], all = 0;
    std::memcpy(words, &v, sizeof v);
    for (const std::uint64_t w : words) all |= w;
    return all != 0;
  }
};

}  // namespace gyro
