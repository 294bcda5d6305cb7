// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/section.hpp"
#include "core/laws/bond/strain.hpp"
#include "core/math/select.hpp"

// Failure criteria of intact bonds. Each compares the stresses of a bond's section with its strengths; the bond fails
// when one of the two ratios reaches 1.

namespace gyro {

/// Stresses of a bond's section [Pa]. The loads of dashpots are left out.
template <class T>
struct BondStress {
  T axial;    ///< sigma_n, mean over the section, tension positive
  T tension;  ///< largest tensile stress, at the edge of the section
  T shear;    ///< largest shear stress, at the edge of the section
};

/// Beam formulas of Potyondy & Cundall, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329:
///
///   sigma_n = kn (L - L0)
///   tension = sigma_n + kn Rb |theta_s|                     with bending
///   shear   = ks L0 (L0/L) c |gamma| + ks Rb |theta_n|      with twist
template <class T>
GYRO_HD BondStress<T> bond_stress(const BondConstants<T>& law, const BondSection<T>& b, const BondStrain<T>& s) {
  using std::sqrt;
  const T kn = bond_detail::normal_stiffness(law, b), ks = bond_detail::shear_stiffness(law, b);
  const T axial = kn * s.stretch, shear_rate = ks * b.length * (b.length / s.length) * s.along;
  return {axial, axial + kn * b.radius * sqrt(norm2(s.bend)),
          shear_rate * sqrt(norm2(s.shear)) + ks * b.radius * magnitude(s.twist)};
}

/// Stress over strength; a bond fails at 1.
template <class T>
struct FailureRatios {
  T tension, shear;  ///< [-]
};

/// Strengths that do not depend on the load:
///
///   tension >= f sigma_c   or   shear >= f tau_c        f the factor of the bond
///
/// Source: Potyondy & Cundall (2004). Departure from Xiong et al. (Minerals 2024, eqs. 3-8), who print Rb^2 in I and J
/// and the minimum of two stresses: misprints.
struct ConstantStrength {
  template <class T>
  GYRO_HD static FailureRatios<T> ratios(const BondConstants<T>& law, T factor, const BondStress<T>& s) {
    return {s.tension / (law.bond.tensile_strength * factor), s.shear / (law.bond.shear_strength * factor)};
  }
};

/// Shear strength that rises with the compression of the bond:
///
///   tension >= f sigma_c   or   shear >= f tau_c + tan(phi) max(0, -sigma_n)
///
/// tau_c is the cohesion, phi the friction angle of the bond. f scales the cohesion alone.
///
/// Source: Potyondy, A flat-jointed bonded-particle material for hard rock, ARMA 12-501 (2012), and the parallel bond
/// of PFC with cohesion and friction angle: tau_max = c - sigma_n tan(phi). Departure: there tension lowers the shear
/// strength, below zero if it is large enough; here only compression counts.
struct MohrCoulomb {
  template <class T>
  GYRO_HD static FailureRatios<T> ratios(const BondConstants<T>& law, T factor, const BondStress<T>& s) {
    const T friction = law.bond.internal_friction * positive(-s.axial);
    return {s.tension / (law.bond.tensile_strength * factor), s.shear / (law.bond.shear_strength * factor + friction)};
  }
};

}  // namespace gyro
