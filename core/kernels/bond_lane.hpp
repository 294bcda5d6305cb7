// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/particle_row.hpp"
#include "core/laws/bond/bond_load.hpp"
#include "core/math/quat.hpp"
#include "core/math/select.hpp"
#include "core/state/bonds.hpp"

// Lanes: how a kernel that works on one bond reads and writes memory. OneLane is one bond, for a GPU
// thread and for tests; PackLanes (bond_pack.hpp) is N neighbouring bonds, for a CPU core. Both do
// the same arithmetic in the same order for every bond, so their results agree to the bit.

namespace gyro {

/// Adds a bond's loads to the rows of its two particles.
template <class Real>
GYRO_HD inline void add_bond_load(Load* rows, Index i, Index j, const BondLoad<Real>& load, Real slip_work) {
  const Vec3d force = cast<double>(load.force);
  Load& a = rows[i];
  a.force -= force;
  a.damped += static_cast<double>(load.damped);
  a.torque += cast<double>(load.torque_i);
  a.slipped += static_cast<double>(slip_work);
  Load& c = rows[j];
  c.force += force;
  c.torque += cast<double>(load.torque_j);
}

/// One bond.
struct OneLane {
  template <class T>
  using Number = T;
  static constexpr int count = 1;
  static constexpr bool in_halves = false;
  Index n;

  template <class T>
  GYRO_HD T load(const T* column) const {
    return column[n];
  }
  template <class To, class T>
  GYRO_HD To load_as(const T* column) const {
    return static_cast<To>(column[n]);
  }
  template <class T, class Row>
  GYRO_HD Vec3<T> vector(const Row* rows, Index row) const {
    return gyro::cast<T>(row_of(rows[row]).vector);
  }
  template <class T, class Row>
  GYRO_HD Vec3<T> difference(const Row* rows, Index a, Index b) const {
    return gyro::cast<T>(row_of(rows[a]).vector - row_of(rows[b]).vector);
  }
  GYRO_HD Quatd quaternion(const Quatd* rows, Index row) const { return rows[row]; }

  template <class Real>
  GYRO_HD BondConstants<Real> spread(const BondConstants<Real>& law) const {
    return law;
  }

  template <class Real>
  GYRO_HD bool is_intact(std::int32_t state) const {
    return state == bond_intact;
  }
  GYRO_HD bool any_unbroken(std::int32_t state) const { return state < bond_broken; }
  GYRO_HD bool any_pressed(std::int32_t state) const { return state == bond_pressed; }
  GYRO_HD bool any(bool m) const { return m; }
  GYRO_HD bool test(bool m, int) const { return m; }
  GYRO_HD Index index(int) const { return n; }
  template <class T>
  GYRO_HD T value(const T& x, int) const {
    return x;
  }

  template <class Real>
  GYRO_HD void add(Load* rows, Index i, Index j, std::int32_t, const BondLoad<Real>& load, Real slip_work) const {
    add_bond_load(rows, i, j, load, slip_work);
  }
};

template <int N>
struct PackLanes;

}  // namespace gyro
