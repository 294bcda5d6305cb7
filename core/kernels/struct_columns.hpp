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
  const auto read = [&](int k, int number, auto& to) {
    std::memcpy(&to, reinterpret_cast<const Real*>(at(k)) + number, sizeof to);
  };
  if constexpr (numbers < 4) {
    for (int c = 0; c < numbers; ++c)
      for (int k = 0; k < N; ++k) {
        Real number;
        read(k, c, number);
        columns[c].v[k] = number;
      }
  } else {
    for (int c = 0; c < numbers; c += 4) {
      const int first = std::min(c, numbers - 4);
      const auto four = row_columns<Real, N>([&](int k) {
        Four<Real> row;
        read(k, first, row);
        return row;
      });
      columns[first] = four.vector.x;
      columns[first + 1] = four.vector.y;
      columns[first + 2] = four.vector.z;
      columns[first + 3] = four.number;
    }
  }
  Struct<Pack<Real, N>> out;
  std::memcpy(static_cast<void*>(&out), columns, sizeof out);
  return out;
}

/// The way back, for at least four numbers.
template <int N, template <class> class Struct, class Real, class At>
void store_structs(const Struct<Pack<Real, N>>& value, const At& at) {
  constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
  static_assert(numbers >= 4 && sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
  Pack<Real, N> columns[numbers];
  std::memcpy(columns, static_cast<const void*>(&value), sizeof columns);
  for (int c = 0; c < numbers; c += 4) {
    const int first = std::min(c, numbers - 4);
    const RowsOfFour<Real, N> rows(columns[first], columns[first + 1], columns[first + 2], columns[first + 3]);
    for (int k = 0; k < N; ++k)
      std::memcpy(reinterpret_cast<char*>(at(k)) + first * static_cast<int>(sizeof(Real)), &rows.row[k],
                  sizeof rows.row[k]);
  }
}

}  // namespace gyro
