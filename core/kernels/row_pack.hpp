// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/row_columns.hpp"
#include "core/kernels/row_lane.hpp"
#include "core/kernels/struct_columns.hpp"

#include <bit>
#include <cstddef>

namespace gyro {

/// N numbers of rows. No vector: each is the address of a load or a store.
template <int N>
struct RowNumbers {
  Index v[N];
};

/// N rows, anywhere in a list: the twin of OneRow (row_lane.hpp) for a CPU core. N is 4 or 8.
template <int N>
struct PackOfRows {
  template <class T>
  using Number = Pack<T, N>;
  static constexpr int count = N;
  const Index* n;  ///< N numbers of rows

  template <class Struct>
  RowNumbers<N> index(const Struct* column, Index Struct::*member) const {
    RowNumbers<N> out;
    for (int k = 0; k < N; ++k) out.v[k] = column[n[k]].*member;
    return out;
  }
  /// Two numbers at once: compilers make a gather of single ones, which is slow on some processors.
  template <class Struct>
  TwoEnds<RowNumbers<N>> both_ends(const Struct* column) const {
    static_assert(offsetof(Struct, i) == 0 && offsetof(Struct, j) == sizeof(Index) &&
                  std::endian::native == std::endian::little);
    TwoEnds<RowNumbers<N>> out;
    for (int k = 0; k < N; ++k) {
      std::uint64_t both;
      std::memcpy(&both, column + n[k], sizeof both);
      out.i.v[k] = static_cast<Index>(both);
      out.j.v[k] = static_cast<Index>(both >> 32);
    }
    return out;
  }
  Pack<double, N> at(const double* column, const RowNumbers<N>& particle) const {
    Pack<double, N> out;
    for (int k = 0; k < N; ++k) out.v[k] = column[particle.v[k]];
    return out;
  }
  template <class Row>
  ParticleRow<Pack<double, N>> row(const Row* rows, const RowNumbers<N>& particle) const {
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
  /// Of rows that are neighbours in the list: bit k is set for row n[k], if its flag is 1 (and not 0).
  std::uint32_t neighbour_flags(const std::int8_t* column) const {
    // The product has each flag once more beside the others, and no carries.
    if constexpr (N == 8)
      return static_cast<std::uint32_t>((vector_at<std::uint64_t>(column + n[0]) * 0x0102040810204080u) >> 56);
    else
      return (vector_at<std::uint32_t>(column + n[0]) * 0x01020408u) >> 24 & 15u;
  }
};

}  // namespace gyro
