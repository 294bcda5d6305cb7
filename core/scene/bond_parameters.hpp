// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"

namespace gyro {

/// Numbers of the bond law, the same for all bonds of a scene. T is the number type that they are used in: a law
/// computes with the same struct. A field takes its value from the key `bonds.<name of the field>`, if there is one.
///
/// k_n = normal_stiffness + normal_modulus/L0 of the bond, k_s likewise: a case gives one part or the other.
template <class T>
struct BondParametersOf {
  T normal_stiffness = 0;   ///< per area [Pa/m]
  T shear_stiffness = 0;    ///< per area [Pa/m]
  T tensile_strength = 0;   ///< sigma_c [Pa]
  T shear_strength = 0;     ///< tau_c [Pa]
  T damping = 0;            ///< xi, fraction of critical damping of each mode of the bond [-]
  T normal_modulus = 0;     ///< k_n L0 [Pa]
  T shear_modulus = 0;      ///< k_s L0 [Pa]
  T internal_friction = 0;  ///< tan(phi) of BondFailure::mohr_coulomb [-]

  template <class F, class... B>
  static constexpr void for_each_field(F&& f, B&... b) {
    f("normal_stiffness", b.normal_stiffness...);
    f("shear_stiffness", b.shear_stiffness...);
    f("tensile_strength", b.tensile_strength...);
    f("shear_strength", b.shear_strength...);
    f("damping", b.damping...);
    f("normal_modulus", b.normal_modulus...);
    f("shear_modulus", b.shear_modulus...);
    f("internal_friction", b.internal_friction...);
  }
};
static_assert(declares_every_field<BondParametersOf<double>>);

using BondParameters = BondParametersOf<double>;

}  // namespace gyro
