// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/dashpots.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// beta_i of largest_dashpot() of each particle, between two windows: held_damping_cap() of one that takes sub-steps
/// and is held by few bonds, 1 of all others. A particle with more bonds passes on what a dashpot gives it; its
/// contacts keep the damping on which the force of a first break depends (1.3 % in place of 0.2 % with the cap on all).
struct FindHeldCaps {
  ConstParticleView p;
  BondIndex bonds;
  double dt;   ///< step of the scene [s]
  double cap;  ///< held_damping_cap() of the bonds [-]
  double* caps;

  static constexpr Index few = 2;  ///< bonds that are not broken

  GYRO_HD void operator()(Index n) const {
    caps[n] = p.step[n] < dt && bonds.begin != nullptr && bonds.count_of(n) <= few ? cap : 1;
  }
};

}  // namespace gyro
