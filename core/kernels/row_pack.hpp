// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/row_columns.hpp"
#include "core/kernels/struct_columns.hpp"

namespace gyro {

/// N rows, anywhere in a list: the twin of OneRow (row_lane.hpp) for a CPU core. N is 4 or 8.
template <int N>
struct PackOfRows {
  template <class T>
  using Number = Pack<T, N>;
  static constexpr int count = N;
  const Index* n;  ///< N numbers of rows

  template <class Struct>
  Pack<Index, N> index(const Struct* column, Index Struct::*member) const {
    Pack<Index, N> out;
    for (int k = 0; k < N; ++k) out.v[k] = column[n[k]].*member;
    return out;
  }
  Pack<double, N> at(const double* column, const Pack<Index, N>& particle) const {
    Pack<double, N> out;
    for (int k = 0; k < N; ++k) out.v[k] = column[particle.v[k]];
    return out;
  }
  template <class Row>
  ParticleRow<Pack<double, N>> row(const Row* rows, const Pack<Index, N>& particle) const {
    return row_columns<double, N>([&](int k) { return whole_row(rows, particle.v[k]); });
  }
  template <template <class> class Struct, class Real>
  void store(Struct<Real>* column, const Struct<Pack<Real, N>>& value) const {
    store_structs<N, Struct, Real>(value, [&](int k) { return column + n[k]; });
  }
  template <class T>
  bool any(const PackMask<T, N>& m) const {
    return any_bit(m.v);
  }
  /// Bit k is set for row n[k], if its flag is 1 (and not 0).
  std::uint32_t flags(const std::int8_t* column) const {
    std::uint32_t bits = 0;
    for (int k = 0; k < N; ++k) bits |= static_cast<std::uint32_t>(column[n[k]]) << k;
    return bits;
  }
};

}  // namespace gyro
