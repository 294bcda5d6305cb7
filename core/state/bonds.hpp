// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/base/hd.hpp"
#include "core/scene/load_table.hpp"
#include "core/state/columns.hpp"

namespace gyro {

/// Life of a bond: it only ever moves to the right.
enum BondState : std::int32_t {
  bond_intact = 0,
  bond_pressed = 1,  ///< broken, ends still pressed together: a spring that only pushes
  bond_broken = 2    ///< broken and apart: the pair is an ordinary contact
};

/// Columns of the bonds. Real is the number type of the loads. A bond holds no history: 60 bytes in
/// mixed precision, 4 of which are ever written while it is intact (the state); a pressed bond also stores its axis.
template <template <class> class Column, class Real>
struct Bonds {
  Column<Index> i, j;                   ///< particles, id of i < id of j
  Column<Real> axis_x, axis_y, axis_z;  ///< from i to j, as in BondShape; pressed: in the world frame
  Column<double> length;                ///< L0: double, because the stretch is a small difference [m]
  Column<Real> radius;                  ///< Rb [m]
  Column<Real> arm;                     ///< a_i, as in BondShape [-]
  Column<Real> strength;                ///< factor on both strengths [-]
  Column<Real> sqrt_mass;               ///< as in BondSection [kg^1/2]
  Column<Real> sqrt_inertia;            ///< as in BondSection [kg^1/2 m]
  Column<std::int32_t> state;           ///< BondState

  template <class F, class... B>
  static constexpr void for_each_column(F&& f, B&... b) {
    f("i", b.i...);
    f("j", b.j...);
    f("axis_x", b.axis_x...);
    f("axis_y", b.axis_y...);
    f("axis_z", b.axis_z...);
    f("length", b.length...);
    f("radius", b.radius...);
    f("arm", b.arm...);
    f("strength", b.strength...);
    f("sqrt_mass", b.sqrt_mass...);
    f("sqrt_inertia", b.sqrt_inertia...);
    f("state", b.state...);
  }
};

template <class Real>
using BondView = Bonds<Pointer, Real>;
template <class Real>
using ConstBondView = Bonds<ConstPointer, Real>;
static_assert(declares_every_column<BondView<float>>());

/// Bonds of a block start at a multiple of this, so that packs of a block never reach into the next.
/// The rows in between hold broken bonds.
inline constexpr Index bond_alignment = 8;

/// What is known of a block as a whole.
enum BlockState : std::int32_t {
  block_intact = 0,  ///< no bond has failed
  block_broken = 1   ///< raise_flag() sets it
};
static_assert(block_broken == 1);

/// The particles and bonds of one rock, or of a piece of a broken one, contiguous in their arrays; or the particles of
/// a broken rock that have no bonds left. Bonds never cross blocks, so a thread (CPU) or a thread block (GPU) owns a
/// rock.
struct Block {
  Index first_particle, end_particle;
  Index first_bond, end_bond;      ///< end is padded to bond_alignment; none once the rock is spent (spent_rocks.hpp)
  Index first_colour, end_colour;  ///< range in the array of colour begins
  RockId rock;
  std::int32_t state;             ///< BlockState
  std::int32_t substeps;          ///< steps of its bonds in a step of the scene; 1 without bonds
  Index table = none;             ///< load table of the rock; none: its rows are made as needed, if it may be rigid
  Index table_bonds = 0;          ///< bonds in the table: those of the block, in their order
  std::int32_t free_of_load = 0;  ///< 1: it may be rigid, or divided into pieces that may. Its particles came into the
                                  ///< scene in one piece, as they lie without loads, and its rows can be made
  std::int32_t rigid = 0;         ///< 1: it moves as a rigid body, and its bonds are not evaluated
  std::int32_t overloaded = 0;    ///< 1: a rigid rock whose bonds must be evaluated again
  std::int32_t listed = 0;        ///< 1: its bonded pairs are in the neighbour lists, as contacts to come
  std::int32_t lacks_rows = 0;    ///< 1: particles that are loaded have no rows of a load table
  double calm = 0;                ///< time for which its bonds have been loaded little [s]

  template <class F, class... B>
  static constexpr void for_each_field(F&& f, B&... b) {
    f("first_particle", b.first_particle...);
    f("end_particle", b.end_particle...);
    f("first_bond", b.first_bond...);
    f("end_bond", b.end_bond...);
    f("first_colour", b.first_colour...);
    f("end_colour", b.end_colour...);
    f("rock", b.rock...);
    f("state", b.state...);
    f("substeps", b.substeps...);
    f("table", b.table...);
    f("table_bonds", b.table_bonds...);
    f("free_of_load", b.free_of_load...);
    f("rigid", b.rigid...);
    f("overloaded", b.overloaded...);
    f("listed", b.listed...);
    f("lacks_rows", b.lacks_rows...);
    f("calm", b.calm...);
  }
};
static_assert(declares_every_field<Block>);

/// Whether the bonds of a block hold it together in one piece that may move as a rigid body, if all of them are intact.
GYRO_HD inline bool may_be_rigid(const Block& b) {
  return b.free_of_load && b.table_bonds > 0 && b.end_particle - b.first_particle <= max_rigid_particles;
}

/// The bonds that are not broken, by particle: row n of `bond` is [begin[n], begin[n + 1]).
struct BondIndex {
  const Index* begin;  ///< null without bonds
  const Index* bond;
  const Index* partner;       ///< at the other end of each
  const std::int32_t* state;  ///< as in Bonds
  const Block* blocks;        ///< null without rocks

  /// @param block_a, block_b  of two particles; none for a sphere that belongs to no rock
  GYRO_HD bool in_one_rock(Index block_a, Index block_b) const {
    return begin != nullptr && block_a == block_b && block_a != none;
  }
  /// The bond of two particles, or none if they have none or it is broken.
  GYRO_HD Index between(Index a, Index b) const {
    for (Index k = begin[a]; k < begin[a + 1]; ++k)
      if (partner[k] == b) return state[bond[k]] == bond_broken ? none : bond[k];
    return none;
  }
};

/// A bond that failed, as the kernel saw it.
struct BreakEvent {
  std::int64_t step;     ///< steps of the scene before the one in which it failed
  std::int32_t substep;  ///< from 0: the sub-step at whose end it failed
  Index bond;
  std::int32_t mode;  ///< BreakMode
  double energy;      ///< [J]
};

}  // namespace gyro
