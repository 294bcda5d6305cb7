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

  Pack<Index, N> first(const Pair* pairs) const {
    Pack<Index, N> i;
    for (int k = 0; k < N; ++k) i.v[k] = pairs[n[k]].i;
    return i;
  }
  Pack<Index, N> second(const Pair* pairs) const {
    Pack<Index, N> j;
    for (int k = 0; k < N; ++k) j.v[k] = pairs[n[k]].j;
    return j;
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
      Real row[numbers];
      std::memcpy(row, column + n[k], sizeof row);
      for (int c = 0; c < numbers; ++c) lanes[c][k] = row[c];
    }
    Struct<Pack<Real, N>> out;
    std::memcpy(static_cast<void*>(&out), lanes, sizeof out);
    return out;
  }
  template <template <class> class Struct, class Real>
  void store(Struct<Real>* column, const Struct<Pack<Real, N>>& value) const {
    constexpr int numbers = sizeof(Struct<Real>) / sizeof(Real);
    static_assert(sizeof(Struct<Pack<Real, N>>) == numbers * sizeof(Pack<Real, N>));
    alignas(64) Real lanes[numbers][N];
    std::memcpy(lanes, static_cast<const void*>(&value), sizeof lanes);
    for (int k = 0; k < N; ++k) {
      Real row[numbers];
      for (int c = 0; c < numbers; ++c) row[c] = lanes[c][k];
      std::memcpy(static_cast<void*>(column + n[k]), row, sizeof row);
    }
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
  ContactConstants<Pack<Real, N>> spread(const ContactConstants<Real>& law) const {
    return gyro::cast<Pack<Real, N>>(law);
  }
  template <class T>
  bool any(const PackMask<T, N>& m) const {
    return any_bit(m.v);
  }
};

}  // namespace gyro
