// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/pair_lane.hpp"
#include "core/kernels/row_pack.hpp"
#include "core/kernels/struct_columns.hpp"

namespace gyro {

/// N pairs.
template <int N>
struct PackOfPairs : PackOfRows<N> {
  using PackOfRows<N>::n;

  template <class Kernel>
  auto in_parts(const Kernel& kernel) const {
    if constexpr (N <= native_lanes)
      return kernel.part(*this);
    else
      return joined(kernel.part(PackOfPairs<N / 2>{n}), kernel.part(PackOfPairs<N / 2>{n + N / 2}));
  }

  /// A struct of equal numbers for each pair, as the same struct of packs.
  template <template <class> class Struct, class Real>
  Struct<Pack<Real, N>> load(const Struct<Real>* column) const {
    return struct_columns<N>(column, [&](int k) { return column + n[k]; });
  }
  template <template <class> class Struct, class Real>
  void store_at(Struct<Real>* column, const RowNumbers<N>& row, const Struct<Pack<Real, N>>& value) const {
    store_structs<N, Struct, Real>(value, [&](int k) { return column + row.v[k]; });
  }
  template <class Real>
  void store_at(Real* column, const RowNumbers<N>& row, const Pack<Real, N>& value) const {
    for (int k = 0; k < N; ++k) column[row.v[k]] = value.v[k];
  }

  template <class Real>
  ContactConstants<Pack<Real, N>> spread(const ContactConstants<Real>& law) const {
    return gyro::cast<Pack<Real, N>>(law);
  }
};

}  // namespace gyro
