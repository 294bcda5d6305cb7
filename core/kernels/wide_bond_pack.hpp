// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/bond_forces.hpp"
#include "core/kernels/bond_pack.hpp"
#include "core/kernels/struct_columns.hpp"

namespace gyro {

/// What a bond law reads of the intact bonds of a pack that is wider than a register of doubles: strains are computed
/// in halves.
template <class Real, class Lanes>
struct WideBondLanes {
  using R = typename Lanes::template Number<Real>;
  BondStrain<R> strain_r;
  BondRates<R> rates;
  BondSection<R> section;

  template <template <class> class Column>
  WideBondLanes(const Lanes& lanes, const ConstParticleView& p, const Bonds<Column, Real>& b) {
    const auto half = [&](int k) { return BondLanes<Real, decltype(lanes.half(k))>(lanes.half(k), p, b).strain_r; };
    strain_r = joined<BondStrain, Real>(half(0), half(1));
    rates = bond_detail::rates_of<Real>(lanes, p, b);
    section = bond_detail::section_of<Real>(lanes, b);
  }
};

}  // namespace gyro
