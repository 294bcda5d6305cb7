// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/row_lane.hpp"
#include "core/laws/contact/contact.hpp"
#include "core/math/select.hpp"
#include "core/state/contacts.hpp"

// Lanes: how the kernel of pairs reads and writes memory. OnePair is one pair, for a GPU thread and for tests;
// PackOfPairs (pair_pack.hpp) is N pairs, for a CPU core. Both do the same arithmetic in the same order for every pair,
// so their results agree to the bit.

namespace gyro {

/// One pair.
struct OnePair : OneRow {
  /// kernel.part() of the lanes, which a pack may compute in parts of a register of doubles.
  template <class Kernel>
  GYRO_HD auto in_parts(const Kernel& kernel) const {
    return kernel.part(*this);
  }
  template <class Struct>
  GYRO_HD auto load(const Struct* column) const {
    return column[n];
  }
  template <class Struct>
  GYRO_HD void store_at(Struct* column, Index row, const Struct& value) const {
    column[row] = value;
  }
  template <class Real>
  GYRO_HD const ContactConstants<Real>& spread(const ContactConstants<Real>& law) const {
    return law;
  }
};

template <int N>
struct PackOfPairs;

}  // namespace gyro
