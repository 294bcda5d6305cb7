// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Second half of a velocity Verlet step: adds up what acts on a particle, in the fixed order
/// gravity, bonds, contacts by partner id, walls by wall id, and gives the second half of the kick.
/// Forces that are held over several steps are added up once and kept.
template <class Real>
struct Gather {
  ParticleView p;
  ConstPairView<Real> pairs;
  ConstWallPairView<Real> walls;
  Vec3d gravity;
  double dt;
  bool with_bonds;
  Load* held;          ///< contacts and walls of each particle; null: evaluated in each step
  bool first_of_hold;  ///< contacts and walls have just been evaluated
  bool kick;           ///< false: only the loads, before the first step of a scene

  GYRO_HD void operator()(Index n) const {
    const Motion motion = p.motion[n];
    LostWork lost = p.losses[n];
    Vec3d force = motion.mass * gravity;
    Vec3d torque{0, 0, 0};
    if (with_bonds) {
      const Load bonds = p.bond_load[n];
      force += bonds.force;
      torque += bonds.torque;
      lost.bond_damping += bonds.damped;
      lost.bond_slip += bonds.slipped;
    }
    if (held == nullptr) {
      add_contacts(n, force, torque, lost);
    } else {
      if (first_of_hold) {
        Load sum;
        add_contacts(n, sum.force, sum.torque, lost);
        held[n] = sum;
      }
      force += held[n].force;
      torque += held[n].torque;
    }
    store(n, force, torque, lost);
  }

 private:
  GYRO_HD void add_contacts(Index n, Vec3d& force, Vec3d& torque, LostWork& lost) const {
    for (Index e = pairs.row_begin[n]; e < pairs.row_begin[n + 1]; ++e) {
      const PairEnd end = pairs.ends[e];
      if (!pairs.touching[end.pair]) continue;
      const PairResult<Real> r = pairs.result[end.pair];
      if (end.side == 0) {
        force += cast<double>(r.force);
        torque += cast<double>(r.torque_i);
        lost.contact_damping += static_cast<double>(r.damped);
        lost.contact_slip += static_cast<double>(r.slipped);
      } else {
        force -= cast<double>(r.force);
        torque += cast<double>(r.torque_j);
      }
    }
    for (Index e = walls.row_begin[n]; e < walls.row_begin[n + 1]; ++e) {
      if (!walls.touching[e]) continue;
      const WallResult<Real> r = walls.result[e];
      force += cast<double>(r.force);
      torque += cast<double>(r.torque);
      lost.contact_damping += static_cast<double>(r.damped);
      lost.contact_slip += static_cast<double>(r.slipped);
    }
  }

  GYRO_HD void store(Index n, const Vec3d& force, const Vec3d& torque, const LostWork& lost) const {
    Load load;
    load.force = force;
    load.torque = torque;
    p.load[n] = load;
    if (!kick) return;
    Motion motion = p.motion[n];
    AngularMotion angular = p.angular_motion[n];
    motion.v += (0.5 * dt / motion.mass) * force;
    angular.w += (0.5 * dt / angular.inertia) * torque;
    p.motion[n] = motion;
    p.angular_motion[n] = angular;
    p.losses[n] = lost;
  }
};

}  // namespace gyro
