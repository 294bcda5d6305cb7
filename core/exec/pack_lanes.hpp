// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/exec/lanes.hpp"
#include "core/math/pack.hpp"
#include "core/state/bonds.hpp"

namespace gyro {

/// N neighbouring bonds, from a multiple of N on. The loads are computed together and added to the
/// particles' rows one bond after the other.
///
/// N = 8 because the strains are double: one 512-bit register. With 16 the doubles take two and the
/// trial ran 30 % slower (core/README.md).
template <int N>
struct PackLanes {
  template <class T>
  using Number = Pack<T, N>;
  static constexpr int count = N;
  Index first;

  template <class T>
  Pack<T, N> load(const T* column) const {
    Pack<T, N> out;
    std::memcpy(&out.v, column + first, sizeof out.v);
    return out;
  }

  /// Gathers component c of rows of `Row`, which start with doubles.
  template <class Row>
  static Pack<double, N> gather(const Row* rows, const Pack<Index, N>& row, int c) {
    alignas(64) double lane[N];
    for (int k = 0; k < N; ++k) lane[k] = reinterpret_cast<const double*>(rows + row.v[k])[c];
    Pack<double, N> out;
    std::memcpy(&out.v, lane, sizeof lane);
    return out;
  }
  template <class Row>
  Vec3<Pack<double, N>> vector(const Row* rows, const Pack<Index, N>& row) const {
    return {gather(rows, row, 0), gather(rows, row, 1), gather(rows, row, 2)};
  }
  Quat<Pack<double, N>> quaternion(const Quatd* rows, const Pack<Index, N>& row) const {
    return {gather(rows, row, 0), gather(rows, row, 1), gather(rows, row, 2), gather(rows, row, 3)};
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
  BondLaw<Pack<Real, N>> spread(const BondLaw<Real>& law) const {
    return spread_law<Pack<Real, N>>(law);
  }

  template <class Real>
  PackMask<Real, N> equal(const Pack<std::int32_t, N>& state, std::int32_t value) const {
    const Pack<Real, N> number = pack_cast<Real>(state);
    return {number.v == Pack<Real, N>(static_cast<Real>(value)).v};
  }
  template <class T>
  bool any(const PackMask<T, N>& m) const {
    bool found = false;
    for (int k = 0; k < N; ++k) found |= m[k];
    return found;
  }
  bool any_below(const Pack<std::int32_t, N>& state, std::int32_t limit) const {
    bool found = false;
    for (int k = 0; k < N; ++k) found |= state.v[k] < limit;
    return found;
  }
  bool any_below_and_not(const Pack<std::int32_t, N>& state, std::int32_t limit, std::int32_t other) const {
    bool found = false;
    for (int k = 0; k < N; ++k) found |= state.v[k] < limit && state.v[k] != other;
    return found;
  }
  template <class T>
  bool test(const PackMask<T, N>& m, int lane) const {
    return m[lane];
  }
  Index index(int lane) const { return first + lane; }
  template <class T>
  T value(const Pack<T, N>& x, int lane) const {
    return x[lane];
  }

  template <class Real>
  void add(Load* rows, const Pack<Index, N>& i, const Pack<Index, N>& j, const Pack<std::int32_t, N>& state,
           const BondLoad<Pack<Real, N>>& load, const Pack<Real, N>& slip_work) const {
    for (int k = 0; k < N; ++k) {
      if (state.v[k] == bond_gone) continue;
      const BondLoad<Real> one{{load.force.x[k], load.force.y[k], load.force.z[k]},
                               {load.moment_i.x[k], load.moment_i.y[k], load.moment_i.z[k]},
                               {load.moment_j.x[k], load.moment_j.y[k], load.moment_j.z[k]},
                               Real(0),
                               Real(0),
                               Real(0),
                               load.damped[k]};
      add_bond_load(rows, i.v[k], j.v[k], one, slip_work[k]);
    }
  }
};

}  // namespace gyro
