// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/math/pack.hpp"

namespace gyro {

/// N structs of equal numbers as one struct of packs.
/// @param at  at(k) points to struct k
template <int N, template <class> class Struct, class Real, class At>
Struct<Pack<Real, N>> struct_columns(const Struct<Real>*, const At& at) {
  constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
  static_assert(sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
  alignas(64) Real lanes[numbers][N];
  for (int k = 0; k < N; ++k) {
    const char* row = reinterpret_cast<const char*>(at(k));
    for (std::size_t c = 0; c < numbers; ++c) std::memcpy(&lanes[c][k], row + c * sizeof(Real), sizeof(Real));
  }
  Struct<Pack<Real, N>> out;
  std::memcpy(static_cast<void*>(&out), lanes, sizeof out);
  return out;
}

/// The way back.
template <int N, template <class> class Struct, class Real, class At>
void store_structs(const Struct<Pack<Real, N>>& value, const At& at) {
  constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
  static_assert(sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
  alignas(64) Real lanes[numbers][N];
  std::memcpy(lanes, static_cast<const void*>(&value), sizeof lanes);
  for (int k = 0; k < N; ++k) {
    char* row = reinterpret_cast<char*>(at(k));
    for (std::size_t c = 0; c < numbers; ++c) std::memcpy(row + c * sizeof(Real), &lanes[c][k], sizeof(Real));
  }
}

}  // namespace gyro
