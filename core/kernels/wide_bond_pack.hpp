// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.
#include "core/kernels/bond_forces.hpp"
#include "core/kernels/bond_pack.hpp"

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
    strain_r = joined(half(0), half(1));
    rates = bond_detail::rates_of<Real>(lanes, p, b);
    section = bond_detail::section_of<Real>(lanes, b);
  }

 private:
  template <class H>
  static Vec3<R> joined(const Vec3<H>& a, const Vec3<H>& b) {
    return {gyro::joined(a.x, b.x), gyro::joined(a.y, b.y), gyro::joined(a.z, b.z)};
  }
  template <class H>
  static BondStrain<R> joined(const BondStrain<H>& a, const BondStrain<H>& b) {
    return {joined(a.normal, b.normal),     gyro::joined(a.length, b.length), gyro::joined(a.stretch, b.stretch),
            gyro::joined(a.along, b.along), joined(a.shear, b.shear),         gyro::joined(a.twist, b.twist),
            joined(a.bend, b.bend)};
  }
};

}  // namespace gyro
