// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/pair_lane.hpp"
#include "core/kernels/row_columns.hpp"
#include "core/kernels/struct_columns.hpp"

#include <utility>

namespace gyro {

/// N pairs, anywhere in the list. N is 4 or 8.
template <int N>
struct PackOfPairs {
  template <class T>
  using Number = Pack<T, N>;
  static constexpr int count = N;
  const Index* n;  ///< N numbers of pairs

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

  /// A struct of equal numbers for each pair, as the same struct of packs.
  template <template <class> class Struct, class Real>
  Struct<Pack<Real, N>> load(const Struct<Real>* column) const {
    return struct_columns<N>(column, [&](int k) { return column + n[k]; });
  }
  template <template <class> class Struct, class Real>
  void store(Struct<Real>* column, const Struct<Pack<Real, N>>& value) const {
    store_structs<N, Struct, Real>(value, [&](int k) { return column + n[k]; });
  }
  template <template <class> class Struct, class Real>
  void store_at(Struct<Real>* column, const Pack<Index, N>& row, const Struct<Pack<Real, N>>& value) const {
    store_structs<N, Struct, Real>(value, [&](int k) { return column + row.v[k]; });
  }

  template <class Real>
  void store_at(Real* column, const Pack<Index, N>& row, const Pack<Real, N>& value) const {
    for (int k = 0; k < N; ++k) column[row.v[k]] = value.v[k];
  }

  template <class Real>
  ContactConstants<Pack<Real, N>> spread(const ContactConstants<Real>& law) const {
    return gyro::cast<Pack<Real, N>>(law);
  }
  template <class T>
  bool any(const PackMask<T, N>& m) const {
    return any_bit(m.v);
  }
};

}  // namespace gyro
