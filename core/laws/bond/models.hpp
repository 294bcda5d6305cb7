// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/bond_load.hpp"
#include "core/scene/bond_model.hpp"

namespace gyro {

/// The one list of bond laws: calls f with the law of a model, as a type. At launch, or where an account is taken;
/// never in a loop over bonds of a step.
GYRO_ANY_CALLEE
template <class F>
GYRO_HD auto with_bond_law(BondModel model, const F& f) {
  switch (model.failure) {
    case BondFailure::mohr_coulomb:
      return f(BondLaw<MohrCoulomb>{});
    case BondFailure::constant:
      break;
  }
  return f(BondLaw<ConstantStrength>{});
}

namespace bond_detail {

/// Calls Law::load() for the law that it is called with: a struct, because device code has no generic lambdas.
template <class T>
struct LoadOf {
  const BondConstants<T>& constants;
  const BondSection<T>& section;
  const BondStrain<T>& strain;
  const BondRates<T>& rates;
  bool pressed;

  template <class Law>
  GYRO_HD BondLoad<T> operator()(Law) const {
    return pressed ? Law::pressed(constants, section, strain, rates).load
                   : Law::load(constants, section, strain, rates);
  }
};

}  // namespace bond_detail

/// Loads of a bond, intact or pressed, under the law of a model.
/// @param bond  with `section`, `strain_r` and `rates`, as BondLanes has them
template <class T, class Bond>
GYRO_HD BondLoad<T> bond_load(BondModel model, const BondConstants<T>& constants, const Bond& bond, bool pressed) {
  return with_bond_law(model, bond_detail::LoadOf<T>{constants, bond.section, bond.strain_r, bond.rates, pressed});
}

}  // namespace gyro
