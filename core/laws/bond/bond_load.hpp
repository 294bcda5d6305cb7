// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/damping.hpp"
#include "core/laws/bond/elastic.hpp"
#include "core/laws/bond/failure.hpp"
#include "core/laws/bond/pressed.hpp"

namespace gyro {

/// A bond law: the springs and dashpots of a parallel bond, and a failure criterion. A type, so that a kernel is
/// compiled for it: what a scene does not name costs nothing.
///
/// Source: Potyondy & Cundall, A bonded-particle model for rock, Int. J. Rock Mech. Min. Sci. 41 (2004) 1329, in total
/// form (strain.hpp).
template <class FailureCriterion>
struct BondLaw {
  using Failure = FailureCriterion;

  /// Loads of an intact bond:
  ///
  ///   F_j = -dU/dx_j - drag, torques likewise                 U of elastic_energy(), drag of bond_drag()
  ///   kn  = normal_stiffness + normal_modulus/L0              ks likewise
  ///
  /// @param s      strains of now, world frame
  /// @param rates  half a step ago, world frame
  template <class T>
  GYRO_HD static BondLoad<T> load(const BondConstants<T>& law, const BondSection<T>& b, const BondStrain<T>& s,
                                  const BondRates<T>& rates) {
    const BondSprings<T> k = bond_detail::springs_of(law, b);
    const ElasticLoads<T> elastic = elastic_loads(k, b.length, b.arm, s);
    const BondDrag<T> drag = bond_drag(law, b, s, rates);
    const FailureRatios<T> ratios = Failure::ratios(law, b.strength, bond_stress(law, b, s));

    BondLoad<T> out;
    out.force = elastic.force - drag.force;
    bond_detail::set_torques(out, b.arm, s.length * s.normal, elastic.couple - drag.twist - drag.bending);
    out.tension_ratio = ratios.tension;
    out.shear_ratio = ratios.shear;
    out.elastic = elastic_energy(k, b.length, s);
    out.damped = drag.work;
    return out;
  }

  /// Loads of a bond that has failed and whose ends have not separated.
  template <class T>
  GYRO_HD static PressedLoad<T> pressed(const BondConstants<T>& law, const BondSection<T>& b, const BondStrain<T>& s,
                                        const BondRates<T>& rates) {
    return pressed_load(law, b, s, rates);
  }
};

}  // namespace gyro
