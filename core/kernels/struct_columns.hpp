// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/row_columns.hpp"

#include <algorithm>

namespace gyro {

// Structs of equal numbers are read and written four numbers at a time and transposed in registers. The last four
// overlap those before them unless the numbers are a multiple of four; less than four go one by one.

/// N structs of equal numbers as one struct of packs.
/// @param at  at(k) points to struct k
template <int N, template <class> class Struct, class Real, class At>
Struct<Pack<Real, N>> struct_columns(const Struct<Real>*, const At& at) {
  constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
  static_assert(sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
  Pack<Real, N> columns[numbers];
  const auto numbers_of = [&](int k, int first) { return reinterpret_cast<const Real*>(at(k)) + first; };
  if constexpr (numbers < 4) {
    for (int c = 0; c < numbers; ++c)
      for (int k = 0; k < N; ++k) columns[c].v[k] = *numbers_of(k, c);
  } else {
    for (int c = 0; c < numbers; c += 4) {
      const int first = std::min(c, numbers - 4);
      const auto four = row_columns<Real, N>([&](int k) { return vector_at<Four<Real>>(numbers_of(k, first)); });
      columns[first] = four.vector.x;
      columns[first + 1] = four.vector.y;
      columns[first + 2] = four.vector.z;
      columns[first + 3] = four.number;
    }
  }
  Struct<Pack<Real, N>> out;
  unrolled<numbers>([&](int c) { store_vector(&out, c, columns[c].v); });
  return out;
}

/// The way back, for at least four numbers.
template <int N, template <class> class Struct, class Real, class At>
void store_structs(const Struct<Pack<Real, N>>& value, const At& at) {
  constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
  static_assert(numbers >= 4 && sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
  using Vector = typename Pack<Real, N>::Vector;
  Pack<Real, N> columns[numbers];
  unrolled<numbers>([&](int c) { columns[c] = Pack<Real, N>{vector_at<Vector>(&value, c)}; });
  unrolled<(numbers + 3) / 4>([&](auto four) {
    constexpr int first = std::min(4 * decltype(four)::value, numbers - 4);
    const RowsOfFour<Real, N> rows(columns[first], columns[first + 1], columns[first + 2], columns[first + 3]);
    unrolled<N>([&](int k) { store_vector(reinterpret_cast<Real*>(at(k)) + first, 0, rows.row[k]); });
  });
}

}  // namespace gyro
