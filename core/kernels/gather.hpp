// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/move.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Adds up what acts on a particle, in the fixed order gravity, bonds, contacts by partner id, walls by wall id. Forces
/// that are held over several steps are added up once and kept.
template <class Real>
struct Gather {
  ParticleView p;
  ConstPairView<Real> pairs;
  ConstWallPairView<Real> walls;
  Vec3d gravity;
  bool with_bonds;
  Load* held;  ///< contacts and walls of each particle; null: no particle has sub-steps

  /// @param mass           [kg]
  /// @param first_of_hold  contacts and walls have just been evaluated
  /// @param lost           of the particle so far; the losses of this step are added
  /// @return the total, without losses
  GYRO_HD Load sum(Index n, double mass, bool first_of_hold, LostWork& lost) const {
    Load total;
    total.force = mass * gravity;
    if (with_bonds) {
      const Load bonds = p.bond_load[n];
      total.force += bonds.force;
      total.torque += bonds.torque;
      lost.bond_damping += bonds.damped;
      lost.bond_slip += bonds.slipped;
    }
    if (held == nullptr) {
      add_contacts(n, mass, total, lost);
    } else {
      if (first_of_hold) {
        Load sum;
        add_contacts(n, mass, sum, lost);
        held[n] = sum;
      }
      total.force += held[n].force;
      total.torque += held[n].torque;
    }
    return total;
  }

 private:
  GYRO_HD void add_contacts(Index n, double mass, Load& to, LostWork& lost) const {
    double dashpots = 0;
    for (Index e = pairs.row_begin[n]; e < pairs.row_begin[n + 1]; ++e) {
      if (!pairs.loaded[e]) continue;
      const EndLoad<Real> load = pairs.load[e];
      to.force += cast<double>(load.force);
      to.torque += cast<double>(load.torque);
      lost.contact_damping += static_cast<double>(load.damped);
      lost.contact_slip += static_cast<double>(load.slipped);
      dashpots += static_cast<double>(pairs.dashpot[e]);
    }
    for (Index e = walls.row_begin[n]; e < walls.row_begin[n + 1]; ++e) {
      if (!walls.touching[e]) continue;
      const WallResult<Real> r = walls.result[e];
      to.force += cast<double>(r.force);
      to.torque += cast<double>(r.torque);
      lost.contact_damping += static_cast<double>(r.damped);
      lost.contact_slip += static_cast<double>(r.slipped);
      dashpots += static_cast<double>(r.dashpot);
    }
    p.damping_rate[n] = dashpots / mass;
  }
};

/// Second half of a velocity Verlet step: the second half of the kick, with the loads of the new position.
template <class Real>
struct FinishStep {
  Gather<Real> gather;
  double dt;  ///< step of the scene [s]
  bool kick;  ///< false: only the loads, before the first step of a scene

  GYRO_HD void operator()(Index n) const {
    const ParticleView& p = gather.p;
    Motion motion = p.motion[n];
    LostWork lost = p.losses[n];
    const double step = p.step[n];
    const Load load = gather.sum(n, motion.mass, step == dt || !kick, lost);
    p.load[n] = load;
    if (!kick) return;
    AngularMotion angular = p.angular_motion[n];
    half_kick(step, load, motion, angular);
    p.motion[n] = motion;
    p.angular_motion[n] = angular;
    p.losses[n] = lost;
  }
};

}  // namespace gyro
