// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/pair_lane.hpp"
#include "core/kernels/row_columns.hpp"

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
    constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
    static_assert(sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
    alignas(64) Real lanes[numbers][N];
    for (int k = 0; k < N; ++k) {
      const char* row = reinterpret_cast<const char*>(column + n[k]);
      for (std::size_t c = 0; c < numbers; ++c) std::memcpy(&lanes[c][k], row + c * sizeof(Real), sizeof(Real));
    }
    Struct<Pack<Real, N>> out;
    std::memcpy(static_cast<void*>(&out), lanes, sizeof out);
    return out;
  }
  template <template <class> class Struct, class Real>
  void store(Struct<Real>* column, const Struct<Pack<Real, N>>& value) const {
    store_rows(
        column, [this](int k) { return n[k]; }, value);
  }
  template <template <class> class Struct, class Real>
  void store_at(Struct<Real>* column, const Pack<Index, N>& row, const Struct<Pack<Real, N>>& value) const {
    store_rows(
        column, [&row](int k) { return row.v[k]; }, value);
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

 private:
  template <template <class> class Struct, class Real, class RowOf>
  static void store_rows(Struct<Real>* column, const RowOf& row_of, const Struct<Pack<Real, N>>& value) {
    constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
    static_assert(sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
    alignas(64) Real lanes[numbers][N];
    std::memcpy(lanes, static_cast<const void*>(&value), sizeof lanes);
    for (int k = 0; k < N; ++k) {
      char* row = reinterpret_cast<char*>(column + row_of(k));
      for (std::size_t c = 0; c < numbers; ++c) std::memcpy(row + c * sizeof(Real), &lanes[c][k], sizeof(Real));
    }
  }
};

}  // namespace gyro
