// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// Life of a bond: it only ever moves to the right.
enum BondState : std::int32_t {
  bond_intact = 0,
  bond_pressed = 1,  ///< failed, ends not apart yet: a spring that only pushes
  bond_broken = 2    ///< apart: the pair is an ordinary contact
};

/// Columns of the bonds. Real is the number type of the loads. A bond holds no history: 60 bytes in
/// mixed precision, 4 of which are ever written while it is glued (the state); an unglued bond also stores its axis.
template <template <class> class Column, class Real>
struct Bonds {
  Column<Index> i, j;  ///< particles, id of i < id of j
  Column<Real> axis_x, axis_y, axis_z;
  Column<double> length;  ///< L0: double, because the stretch is a small difference [m]
  Column<Real> radius, arm, strength, sqrt_mass, sqrt_inertia;
  Column<std::int32_t> state;
};

/// Calls f(name, column...) for every column of the bonds given, in step.
template <class F, class... B>
void for_each_bond_column(F&& f, B&... b) {
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

template <class Real>
using BondView = Bonds<Pointer, Real>;
static_assert(sizeof(BondView<float>) == 12 * sizeof(void*), "a new column needs a line in for_each_bond_column");

/// Bonds of a block start at a multiple of this, so that packs of a block never reach into the next.
/// The places in between hold bonds that are gone.
inline constexpr Index bond_alignment = 8;

/// What is known of a block as a whole.
enum BlockState : std::int32_t {
  block_intact = 0,  ///< no bond has failed: bonded pairs are not listed as contacts to come
  block_broken = 1
};

/// The particles and bonds of one rock, contiguous in their arrays. Bonds never cross blocks, so a
/// thread (CPU) or a thread block (GPU) owns a rock.
struct Block {
  Index first_particle, end_particle;
  Index first_bond, end_bond;      ///< end is padded to bond_alignment
  Index first_colour, end_colour;  ///< range in the array of colour begins
  RockId rock;
  std::int32_t state;
};

/// All blocks of a scene, as executors see them.
struct BlockList {
  const Block* blocks;
  Index count;
  const Index* colour_begin;
  Index colour_size;  ///< bonds in a colour, on average over all blocks: how many threads have work at once
};

/// A bond that failed, as the kernel saw it.
struct BreakEvent {
  std::int64_t step;
  Index bond;
  std::int32_t mode;  ///< BreakMode
  double energy;      ///< [J]
};

}  // namespace gyro
