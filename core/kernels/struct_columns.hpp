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
  Struct<Pack<Real, N>> out;  // written vector by vector: compilers copy arrays of vectors in shorter pieces
  const auto numbers_of = [&](int k, int first) { return reinterpret_cast<const Real*>(at(k)) + first; };
  if constexpr (numbers < 4) {
    for (int c = 0; c < numbers; ++c) {
      Pack<Real, N> column;
      for (int k = 0; k < N; ++k) column.v[k] = *numbers_of(k, c);
      store_vector(&out, c, column.v);
    }
  } else {
    for (int c = 0; c < numbers; c += 4) {
      const int first = std::min(c, numbers - 4);
      const auto four = row_columns<Real, N>([&](int k) { return vector_at<Four<Real>>(numbers_of(k, first)); });
      store_vector(&out, first, four.vector.x.v);
      store_vector(&out, first + 1, four.vector.y.v);
      store_vector(&out, first + 2, four.vector.z.v);
      store_vector(&out, first + 3, four.number.v);
    }
  }
  return out;
}

/// Two structs of packs as one of packs that are twice as long.
template <template <class> class Struct, class Real>
Struct<Pack<Real, 8>> joined(const Struct<Pack<Real, 4>>& low, const Struct<Pack<Real, 4>>& high) {
  constexpr int numbers = sizeof low / sizeof(Pack<Real, 4>);
  Struct<Pack<Real, 8>> out;
  const auto column = [](const auto& half, int c) { return Pack<Real, 4>{vector_at<Four<Real>>(&half, c)}; };
  for (int c = 0; c < numbers; ++c) store_vector(&out, c, joined(column(low, c), column(high, c)).v);
  return out;
}

/// The way back, for at least four numbers.
template <int N, template <class> class Struct, class Real, class At>
void store_structs(const Struct<Pack<Real, N>>& value, const At& at) {
  constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
  static_assert(numbers >= 4 && sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
  const auto column = [&](int c) { return Pack<Real, N>{vector_at<typename Pack<Real, N>::Vector>(&value, c)}; };
  for (int c = 0; c < numbers; c += 4) {
    const int first = std::min(c, numbers - 4);
    const RowsOfFour<Real, N> rows(column(first), column(first + 1), column(first + 2), column(first + 3));
    unrolled<N>([&](int k) { store_vector(reinterpret_cast<Real*>(at(k)) + first, 0, rows.row[k]); });
  }
}

}  // namespace gyro
