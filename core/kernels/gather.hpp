// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/state/contacts.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Second half of a velocity Verlet step: adds up what acts on a particle, in the fixed order
/// gravity, bonds, contacts by partner id, walls by wall id, and gives the second half of the kick.
/// Forces that are held over several steps are added up once and kept.
template <class Real>
struct Gather {
  ParticleView p;
  PairView<Real> pairs;
  WallView<Real> walls;
  Vec3d gravity;
  double dt;
  bool with_bonds;
  Load* held;  ///< contacts and walls of each particle; null: evaluated anew in each step
  bool fresh;  ///< contacts and walls have just been evaluated
  bool kick;   ///< false: only the loads, for a scene that has just been put together

  GYRO_HD void operator()(Index n) const {
    const Motion motion = p.motion[n];
    LostWork lost = p.losses[n];
    Vec3d force = motion.mass * gravity;
    Vec3d moment{0, 0, 0};
    if (with_bonds) {
      const Load bonds = p.bond_load[n];
      force += bonds.force;
      moment += bonds.moment;
      lost.bond_damping += bonds.damped;
      lost.bond_slip += bonds.slipped;
    }
    if (held == nullptr) {
      add_contacts(n, force, moment, lost);
    } else {
      if (fresh) {
        Load sum;
        add_contacts(n, sum.force, sum.moment, lost);
        held[n] = sum;
      }
      force += held[n].force;
      moment += held[n].moment;
    }
    store(n, force, moment, lost);
  }

 private:
  GYRO_HD void add_contacts(Index n, Vec3d& force, Vec3d& moment, LostWork& lost) const {
    for (Index e = pairs.row_begin[n]; e < pairs.row_begin[n + 1]; ++e) {
      const PairEnd end = pairs.ends[e];
      if (!pairs.touching[end.pair]) continue;
      const PairResult<Real> r = pairs.result[end.pair];
      if (end.side == 0) {
        force += cast<double>(r.force);
        moment += cast<double>(r.moment_i);
        lost.contact_damping += static_cast<double>(r.damped);
        lost.contact_slip += static_cast<double>(r.slipped);
      } else {
        force -= cast<double>(r.force);
        moment += cast<double>(r.moment_j);
      }
    }
    for (Index e = walls.row_begin[n]; e < walls.row_begin[n + 1]; ++e) {
      if (!walls.touching[e]) continue;
      const WallResult<Real> r = walls.result[e];
      force += cast<double>(r.force);
      moment += cast<double>(r.moment);
      lost.contact_damping += static_cast<double>(r.damped);
      lost.contact_slip += static_cast<double>(r.slipped);
    }
  }

  GYRO_HD void store(Index n, const Vec3d& force, const Vec3d& moment, const LostWork& lost) const {
    Load load;
    load.force = force;
    load.moment = moment;
    p.load[n] = load;
    if (!kick) return;
    Motion motion = p.motion[n];
    Spin spin = p.spin[n];
    motion.v += (0.5 * dt / motion.mass) * force;
    spin.w += (0.5 * dt / spin.inertia) * moment;
    p.motion[n] = motion;
    p.spin[n] = spin;
    p.losses[n] = lost;
  }
};

}  // namespace gyro
