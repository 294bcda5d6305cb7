// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/index_range.hpp"
#include "core/kernels/bond_forces.hpp"
#include "core/kernels/gather.hpp"
#include "core/kernels/move.hpp"
#include "core/state/pieces.hpp"

namespace gyro {

/// What happens to a particle before the bonds are evaluated.
enum class Motions {
  loads_only,  ///< before the first step of a scene
  move,        ///< the first step of a window: the last step is complete
  move_on,     ///< the last step has new contact forces, which it takes over
  move_held,   ///< the last step has the contact forces that are held
};

/// From the forces of one step to the bond forces of the next, rock by rock: the second half of a step, the first half
/// of the next, and the bonds at the new positions. A rock of some hundred particles stays in a core's cache meanwhile.
/// Forces between rocks and of walls are evaluated elsewhere, once in a step of the scene; while they are held, a rock
/// takes all its sub-steps in one go (passes).
///
/// A kernel for Exec::for_each_block: a block is a piece, its rows are particles, its items are bonds. Law is a bond
/// law of core/laws/bond/models.hpp.
template <class Real, class Law>
struct AdvanceRocks {
  using Lane = OneLane;                           ///< of a GPU thread
  using Pack = PackLanes<load_lanes<Real>>;       ///< of a CPU core
  using RowPack = PackOfParticles<native_lanes>;  ///< of a CPU core
  static constexpr int blocks_at_once = sizeof(Real) == 8 ? 2 : 4;

  const Piece* pieces;
  const Block* blocks;
  const Index* colour_begin;  ///< first bond of each colour; a block has one entry more than colours
  Gather<Real> gather;
  Move move;
  BondForces<Real, Law> bonds;
  Motions first;       ///< in the first pass; later ones are move_held
  std::int64_t step;   ///< steps of the scene before that in which contact forces were evaluated last, or of the first
  int first_substep;   ///< sub-step of the first pass, as in BreakEvent; from the number of sub-steps on of the next
                       ///< step
  bool to_next;        ///< after move_on: through the first sub-step of the next step, or to the end of this one
  int only_pass = -1;  ///< >= 0: this pass alone

  GYRO_HD IndexRange rows(Index k) const { return {pieces[k].first_particle, pieces[k].end_particle}; }
  GYRO_HD IndexRange share(Index k) const { return rows(k); }
  GYRO_HD IndexRange items(Index k) const {
    return pieces[k].block == none ? IndexRange{0, 0}
                                   : IndexRange{blocks[pieces[k].block].first_bond, blocks[pieces[k].block].end_bond};
  }
  GYRO_HD IndexRange colours(Index k) const {
    return pieces[k].block == none
               ? IndexRange{0, 0}
               : IndexRange{blocks[pieces[k].block].first_colour, blocks[pieces[k].block].end_colour - 1};
  }
  /// Bonds that share no particle.
  GYRO_HD IndexRange items_of_colour(Index colour) const { return {colour_begin[colour], colour_begin[colour + 1]}; }

  /// None for rocks that move as rigid bodies (rigid_rocks.hpp).
  GYRO_HD int passes(Index k) const {
    if (pieces[k].block != none && blocks[pieces[k].block].rigid) return 0;
    return only_pass >= 0 ? 1 : all_passes(pieces[k].substeps);
  }
  GYRO_HD int all_passes(int substeps) const {
    return first != Motions::move_on ? 1 : to_next ? substeps : substeps - 1;
  }

  GYRO_HD void prepare(Index particle, Index k, int pass) const { prepare(OneParticle{particle}, k, pass); }
  template <class Lanes>
  GYRO_FLATTEN GYRO_HD void prepare(const Lanes& particles, Index, int pass) const {
    const Motions motions = number_of(pass) == 0 ? first : Motions::move_held;
    if (motions != Motions::loads_only) advance(particles, motions);
    if (gather.with_bonds) particles.clear(gather.p.bond_load);
  }

  template <class Lanes>
  GYRO_HD void operator()(const Lanes& lanes, Index k, int pass) const {
    bonds(lanes, when(pieces[k].block, pass, gather.p.step[pieces[k].first_particle]));
  }
  /// @param dt  of the block's particles [s]
  GYRO_HD BondStep when(Index block, int pass, double dt) const {
    return {block, step, first_substep + number_of(pass), dt};
  }

 private:
  GYRO_HD int number_of(int pass) const { return only_pass >= 0 ? only_pass : pass; }

  template <class Lanes>
  GYRO_HD void advance(const Lanes& lanes, Motions motions) const {
    using D = typename Lanes::template Number<double>;
    const ParticleView& p = gather.p;
    const D dt = lanes.load(p.step);
    ParticleRow<D> motion = lanes.load(p.motion), angular = lanes.load(p.angular_motion);
    if (motions == Motions::move) return move(lanes, dt, lanes.load(p.load), motion, angular);
    const ForceAndTorque<D> load = gather.sum(lanes, motion.number, motions == Motions::move_on);
    half_kick(dt, load, motion, angular);
    move(lanes, dt, load, motion, angular);
  }
};

/// The bonds of one large rock, part by part, for Exec::for_each_block: its particles have been moved already.
template <class Real, class Law>
struct PartBonds {
  using Lane = OneLane;
  using Pack = PackLanes<load_lanes<Real>>;
  static constexpr int blocks_at_once = AdvanceRocks<Real, Law>::blocks_at_once;

  const Part* parts;
  const Index* colour_begin;
  BondForces<Real, Law> bonds;
  BondStep when;

  GYRO_HD IndexRange items(Index k) const { return {parts[k].first_bond, parts[k].end_bond}; }
  GYRO_HD IndexRange share(Index k) const { return items(k); }
  GYRO_HD IndexRange colours(Index k) const { return {parts[k].first_colour, parts[k].end_colour}; }
  GYRO_HD IndexRange items_of_colour(Index colour) const { return {colour_begin[colour], colour_begin[colour + 1]}; }
  GYRO_HD static int passes(Index) { return 1; }

  template <class Lanes>
  GYRO_HD void operator()(const Lanes& lanes, Index, int) const {
    bonds(lanes, when);
  }
};

}  // namespace gyro
