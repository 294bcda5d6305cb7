// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/particle_row.hpp"
#include "core/math/pack.hpp"

namespace gyro {

/// Four numbers side by side.
template <class T>
using Four = typename VectorOf<T, 4>::type;

/// A row of four doubles.
template <class Row>
Four<double> whole_row(const Row* rows, Index row) {
  static_assert(sizeof(Row) == sizeof(Four<double>));
  return vector_at<Four<double>>(rows + row);
}

/// The columns of N rows of four doubles, as packs of T. Rows are loaded whole and transposed in registers: half the
/// instructions of a gather number by number.
/// @param row  row(k) is row k, a Four of any number type
template <class T, int N, class RowOf>
ParticleRow<Pack<T, N>> row_columns(const RowOf& row) {
  const auto r = [&](int k) { return __builtin_convertvector(row(k), Four<T>); };
  const auto join = [&](int a, int b) { return __builtin_shufflevector(r(a), r(b), 0, 1, 2, 3, 4, 5, 6, 7); };
  using P = Pack<T, N>;
  if constexpr (N == 4) {
    // x0 x1 z0 z1, y0 y1 w0 w1, ...
    const auto xz01 = __builtin_shufflevector(r(0), r(1), 0, 4, 2, 6),
               yw01 = __builtin_shufflevector(r(0), r(1), 1, 5, 3, 7);
    const auto xz23 = __builtin_shufflevector(r(2), r(3), 0, 4, 2, 6),
               yw23 = __builtin_shufflevector(r(2), r(3), 1, 5, 3, 7);
    return {{P{__builtin_shufflevector(xz01, xz23, 0, 1, 4, 5)}, P{__builtin_shufflevector(yw01, yw23, 0, 1, 4, 5)},
             P{__builtin_shufflevector(xz01, xz23, 2, 3, 6, 7)}},
            P{__builtin_shufflevector(yw01, yw23, 2, 3, 6, 7)}};
  } else if constexpr (sizeof(T) == 8) {
    static_assert(N == 8);
    const auto r02 = join(0, 2), r13 = join(1, 3), r46 = join(4, 6), r57 = join(5, 7);
    // x0 x1 z0 z1 x2 x3 z2 z3, ...
    const auto xz03 = __builtin_shufflevector(r02, r13, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto yw03 = __builtin_shufflevector(r02, r13, 1, 9, 3, 11, 5, 13, 7, 15);
    const auto xz47 = __builtin_shufflevector(r46, r57, 0, 8, 2, 10, 4, 12, 6, 14);
    const auto yw47 = __builtin_shufflevector(r46, r57, 1, 9, 3, 11, 5, 13, 7, 15);
    return {{P{__builtin_shufflevector(xz03, xz47, 0, 1, 4, 5, 8, 9, 12, 13)},
             P{__builtin_shufflevector(yw03, yw47, 0, 1, 4, 5, 8, 9, 12, 13)},
             P{__builtin_shufflevector(xz03, xz47, 2, 3, 6, 7, 10, 11, 14, 15)}},
            P{__builtin_shufflevector(yw03, yw47, 2, 3, 6, 7, 10, 11, 14, 15)}};
  } else {
    static_assert(N == 8);
    const auto r04 = join(0, 4), r15 = join(1, 5), r26 = join(2, 6), r37 = join(3, 7);
    // x0 x1 y0 y1 x4 x5 y4 y5, ...
    const auto xy01 = __builtin_shufflevector(r04, r15, 0, 8, 1, 9, 4, 12, 5, 13);
    const auto zw01 = __builtin_shufflevector(r04, r15, 2, 10, 3, 11, 6, 14, 7, 15);
    const auto xy23 = __builtin_shufflevector(r26, r37, 0, 8, 1, 9, 4, 12, 5, 13);
    const auto zw23 = __builtin_shufflevector(r26, r37, 2, 10, 3, 11, 6, 14, 7, 15);
    return {{P{__builtin_shufflevector(xy01, xy23, 0, 1, 8, 9, 4, 5, 12, 13)},
             P{__builtin_shufflevector(xy01, xy23, 2, 3, 10, 11, 6, 7, 14, 15)},
             P{__builtin_shufflevector(zw01, zw23, 0, 1, 8, 9, 4, 5, 12, 13)}},
            P{__builtin_shufflevector(zw01, zw23, 2, 3, 10, 11, 6, 7, 14, 15)}};
  }
}

/// The way back: N rows of four numbers from their columns.
template <class T, int N>
struct RowsOfFour {
  Four<T> row[N];

  RowsOfFour(const Pack<T, N>& x, const Pack<T, N>& y, const Pack<T, N>& z, const Pack<T, N>& w) {
    if constexpr (N == 4) {
      const auto xy01 = __builtin_shufflevector(x.v, y.v, 0, 4, 1, 5),
                 xy23 = __builtin_shufflevector(x.v, y.v, 2, 6, 3, 7);
      const auto zw01 = __builtin_shufflevector(z.v, w.v, 0, 4, 1, 5),
                 zw23 = __builtin_shufflevector(z.v, w.v, 2, 6, 3, 7);
      row[0] = __builtin_shufflevector(xy01, zw01, 0, 1, 4, 5);
      row[1] = __builtin_shufflevector(xy01, zw01, 2, 3, 6, 7);
      row[2] = __builtin_shufflevector(xy23, zw23, 0, 1, 4, 5);
      row[3] = __builtin_shufflevector(xy23, zw23, 2, 3, 6, 7);
    } else if constexpr (sizeof(T) == 4) {
      static_assert(N == 8);
      // As with four, in each half of the register, which is one instruction of AVX2.
      // x0 y0 x1 y1 x4 y4 x5 y5, ...: rows 0 and 4, 1 and 5, 2 and 6, 3 and 7.
      const auto xy01 = __builtin_shufflevector(x.v, y.v, 0, 8, 1, 9, 4, 12, 5, 13),
                 xy23 = __builtin_shufflevector(x.v, y.v, 2, 10, 3, 11, 6, 14, 7, 15);
      const auto zw01 = __builtin_shufflevector(z.v, w.v, 0, 8, 1, 9, 4, 12, 5, 13),
                 zw23 = __builtin_shufflevector(z.v, w.v, 2, 10, 3, 11, 6, 14, 7, 15);
      set(0, 4, __builtin_shufflevector(xy01, zw01, 0, 1, 8, 9, 4, 5, 12, 13));
      set(1, 5, __builtin_shufflevector(xy01, zw01, 2, 3, 10, 11, 6, 7, 14, 15));
      set(2, 6, __builtin_shufflevector(xy23, zw23, 0, 1, 8, 9, 4, 5, 12, 13));
      set(3, 7, __builtin_shufflevector(xy23, zw23, 2, 3, 10, 11, 6, 7, 14, 15));
    } else {
      static_assert(N == 8);
      // Of x0 y0 x2 y2 x4 y4 x6 y6, ...: rows 0 and 4, 2 and 6, 1 and 5, 3 and 7.
      const auto xy_even = __builtin_shufflevector(x.v, y.v, 0, 8, 2, 10, 4, 12, 6, 14),
                 xy_odd = __builtin_shufflevector(x.v, y.v, 1, 9, 3, 11, 5, 13, 7, 15);
      const auto zw_even = __builtin_shufflevector(z.v, w.v, 0, 8, 2, 10, 4, 12, 6, 14),
                 zw_odd = __builtin_shufflevector(z.v, w.v, 1, 9, 3, 11, 5, 13, 7, 15);
      set(0, 4, __builtin_shufflevector(xy_even, zw_even, 0, 1, 8, 9, 4, 5, 12, 13));
      set(2, 6, __builtin_shufflevector(xy_even, zw_even, 2, 3, 10, 11, 6, 7, 14, 15));
      set(1, 5, __builtin_shufflevector(xy_odd, zw_odd, 0, 1, 8, 9, 4, 5, 12, 13));
      set(3, 7, __builtin_shufflevector(xy_odd, zw_odd, 2, 3, 10, 11, 6, 7, 14, 15));
    }
  }

 private:
  template <class Two>
  void set(int a, int b, const Two& rows) {
    row[a] = __builtin_shufflevector(rows, rows, 0, 1, 2, 3);
    row[b] = __builtin_shufflevector(rows, rows, 4, 5, 6, 7);
  }
};

/// row_columns() of N rows that lie side by side: fewer instructions, because two rows are loaded at once.
template <int N, class Row>
ParticleRow<Pack<double, N>> neighbour_columns(const Row* rows) {
  static_assert(sizeof(Row) == sizeof(Four<double>));
  using P = Pack<double, N>;
  if constexpr (N == 4) {
    return row_columns<double, N>([&](int k) { return whole_row(rows, k); });
  } else {
    static_assert(N == 8);
    const auto two = [&](int k) { return vector_at<typename P::Vector>(rows, k); };
    // x0 x1 x2 x3 y0 y1 y2 y3, ...
    const auto xy03 = __builtin_shufflevector(two(0), two(1), 0, 4, 8, 12, 1, 5, 9, 13),
               zw03 = __builtin_shufflevector(two(0), two(1), 2, 6, 10, 14, 3, 7, 11, 15),
               xy47 = __builtin_shufflevector(two(2), two(3), 0, 4, 8, 12, 1, 5, 9, 13),
               zw47 = __builtin_shufflevector(two(2), two(3), 2, 6, 10, 14, 3, 7, 11, 15);
    return {{P{__builtin_shufflevector(xy03, xy47, 0, 1, 2, 3, 8, 9, 10, 11)},
             P{__builtin_shufflevector(xy03, xy47, 4, 5, 6, 7, 12, 13, 14, 15)},
             P{__builtin_shufflevector(zw03, zw47, 0, 1, 2, 3, 8, 9, 10, 11)}},
            P{__builtin_shufflevector(zw03, zw47, 4, 5, 6, 7, 12, 13, 14, 15)}};
  }
}

/// The way back: fewer instructions than RowsOfFour, because two rows are stored at once.
template <int N, class Row>
void store_neighbours(Row* rows, const ParticleRow<Pack<double, N>>& columns) {
  static_assert(sizeof(Row) == sizeof(Four<double>));
  if constexpr (N == 4) {
    const RowsOfFour<double, N> of(columns.vector.x, columns.vector.y, columns.vector.z, columns.number);
    unrolled<N>([&](int k) { store_vector(rows, k, of.row[k]); });
  } else {
    static_assert(N == 8);
    const auto &x = columns.vector.x.v, &y = columns.vector.y.v, &z = columns.vector.z.v, &w = columns.number.v;
    // x0 y0 x1 y1 x2 y2 x3 y3, ...
    const auto xy03 = __builtin_shufflevector(x, y, 0, 8, 1, 9, 2, 10, 3, 11),
               zw03 = __builtin_shufflevector(z, w, 0, 8, 1, 9, 2, 10, 3, 11),
               xy47 = __builtin_shufflevector(x, y, 4, 12, 5, 13, 6, 14, 7, 15),
               zw47 = __builtin_shufflevector(z, w, 4, 12, 5, 13, 6, 14, 7, 15);
    store_vector(rows, 0, __builtin_shufflevector(xy03, zw03, 0, 1, 8, 9, 2, 3, 10, 11));
    store_vector(rows, 1, __builtin_shufflevector(xy03, zw03, 4, 5, 12, 13, 6, 7, 14, 15));
    store_vector(rows, 2, __builtin_shufflevector(xy47, zw47, 0, 1, 8, 9, 2, 3, 10, 11));
    store_vector(rows, 3, __builtin_shufflevector(xy47, zw47, 4, 5, 12, 13, 6, 7, 14, 15));
  }
}

}  // namespace gyro
