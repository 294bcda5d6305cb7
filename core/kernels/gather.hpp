// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/move.hpp"
#include "core/state/bonds.hpp"
#include "core/state/particles.hpp"
#include "core/state/walls.hpp"

namespace gyro {

/// Adds up what acts on the particles of some lanes, in the fixed order gravity, bonds, contacts by partner id, walls
/// by wall id. Forces that are held over several steps are added up once and kept.
template <class Real>
struct Gather {
  ParticleView p;
  ConstPairView<Real> pairs;
  ConstWallPairView<Real> walls;
  Vec3d gravity;
  bool with_bonds;
  Load* held;  ///< contacts and walls of each particle; null: no particle has sub-steps

  /// The total. What the sources lost is added to the losses of the particles.
  /// @param mass           [kg]
  /// @param first_of_hold  contacts and walls have just been evaluated
  template <class Lanes, class D>
  GYRO_HD ForceAndTorque<D> sum(const Lanes& lanes, const D& mass, bool first_of_hold) const {
    const Vec3<D> zero{D(0), D(0), D(0)};
    ForceAndTorque<D> total{mass * Vec3<D>{D(gravity.x), D(gravity.y), D(gravity.z)}, zero};
    if (with_bonds) {
      add(total, lanes.load(p.bond_load));
      for (int k = 0; k < Lanes::count; ++k) add_bond_losses(lanes.particle(k));
    }
    if (held == nullptr) {
      add_contacts(lanes, mass, total);
    } else if (first_of_hold) {
      ForceAndTorque<D> contacts{zero, zero};
      add_contacts(lanes, mass, contacts);
      lanes.store(held, contacts);
      add(total, contacts);
    } else {
      add(total, lanes.load(held));
    }
    return total;
  }

  /// Adds the contacts of a particle, one after the other.
  template <class Sum>
  GYRO_HD void add_contacts_of(Index n, Sum& sum) const {
    sum.take(p.losses[n]);
    for (Index e = pairs.row_begin[n]; e < pairs.row_begin[n + 1]; ++e)
      sum.add(pairs.loaded[e], pairs.load[e], pairs.dashpot[e]);
    for (Index e = walls.row_begin[n]; e < walls.row_begin[n + 1]; ++e)
      sum.add(walls.touching[e], walls.result[e], walls.result[e].dashpot);
    sum.give(p.losses[n]);
  }
  /// Contacts that these particles may have.
  GYRO_HD Index listed(Index from, Index end) const {
    return pairs.row_begin[end] - pairs.row_begin[from] + (walls.row_begin[end] - walls.row_begin[from]);
  }

 private:
  template <class D>
  GYRO_HD static void add(ForceAndTorque<D>& total, const ForceAndTorque<D>& more) {
    total.force += more.force;
    total.torque += more.torque;
  }
  GYRO_HD void add_bond_losses(Index n) const {
    p.losses[n].bond_damping += p.bond_load[n].damped;
    p.losses[n].bond_slip += p.bond_load[n].slipped;
  }
  template <class Lanes, class D>
  GYRO_HD void add_contacts(const Lanes& lanes, const D& mass, ForceAndTorque<D>& to) const {
    const D dashpots = lanes.add_contacts(*this, to);
    lanes.store(p.damping_rate, dashpots / mass);
  }
};

/// Second half of a velocity Verlet step: the second half of the kick, with the loads of the new position. Particles of
/// rigid rocks only get their loads.
template <class Real>
struct FinishStep {
  Gather<Real> gather;
  double dt;                  ///< step of the scene [s]
  bool kick;                  ///< false: only the loads, before the first step of a scene
  const Block* may_be_rigid;  ///< blocks of a scene where rocks may move as rigid bodies, or null

  GYRO_HD void operator()(Index n) const {
    const OneParticle lanes{n};
    const ParticleView& p = gather.p;
    ParticleRow<double> motion = lanes.load(p.motion);
    const LostWork lost = p.losses[n];
    const double step = p.step[n];
    const ForceAndTorque<double> load = gather.sum(lanes, motion.number, step == dt || !kick);
    lanes.store(p.load, load);
    if (!kick) {
      p.losses[n] = lost;
      return;
    }
    if (may_be_rigid != nullptr && p.block[n] != none && may_be_rigid[p.block[n]].rigid) return;
    ParticleRow<double> angular = lanes.load(p.angular_motion);
    half_kick(step, load, motion, angular);
    lanes.store(p.motion, motion);
    lanes.store(p.angular_motion, angular);
  }
};

}  // namespace gyro
