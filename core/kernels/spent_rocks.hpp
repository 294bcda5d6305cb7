// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"

// Rocks that need their sub-steps no more: all of their bonds are broken and apart.

namespace gyro {

/// @param bonded  not 0: the rock has a bond that is intact or pressed
GYRO_HD inline bool is_spent(const Block& block, std::int32_t bonded) {
  return block.substeps > 1 && bonded == 0;
}

/// 1 for each rock that is spent; the map of a sum over rocks.
struct SpentRocks {
  const Block* blocks;
  const std::int32_t* bonded;  ///< of each block, as in is_spent()

  GYRO_HD Index operator()(Index k) const { return is_spent(blocks[k], bonded[k]) ? 1 : 0; }
};

struct ClearBonded {
  std::int32_t* bonded;
  GYRO_HD void operator()(Index k) const { bonded[k] = 0; }
};

/// Of each bond: marks its rock unless the bond is broken.
struct MarkBonded {
  const Index* i;             ///< as in Bonds
  const std::int32_t* state;  ///< as in Bonds
  const Index* block;         ///< of each particle
  std::int32_t* bonded;

  GYRO_HD void operator()(Index n) const {
    if (state[n] == bond_broken) return;
    std::int32_t* flag = bonded + block[i[n]];
    if (!is_raised(flag)) raise_flag(flag);
  }
};

/// Gives the particles of spent rocks the step of the scene, between two windows.
///
/// What acts in the first half kick of the next window is half a step of the particle: with h the step that it had, the
/// contact forces F of the last evaluation have acted for dt - h/2 and have h/2 left, which is also what the walls have
/// been told and what is booked with them. Gravity G acts in all of dt/2. Hence the loads become
///
///   G + (F - G) h/dt,   M h/dt
///
/// with F and M the total force and torque: impulses are as if the rock had kept its sub-steps, to rounding. The next
/// contact forces act from the middle of the next step on, those of the rock's last hold to h/2 after the window's
/// begin: no contact acts in the (dt - h)/2 between, which the rock was ahead of the scene.
struct LoosenSpent {
  ParticleView p;
  SpentRocks spent;
  Vec3d gravity;  ///< [m/s2]
  double dt;      ///< step of the scene [s]

  GYRO_HD void operator()(Index n) const {
    if (p.block[n] == none || spent(p.block[n]) == 0) return;
    const Vec3d weight = p.motion[n].mass * gravity;
    const double share = p.step[n] / dt;
    p.load[n].force = weight + share * (p.load[n].force - weight);
    p.load[n].torque = share * p.load[n].torque;
    p.step[n] = dt;
  }
};

}  // namespace gyro
