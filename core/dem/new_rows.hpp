// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/state/bonds.hpp"
#include "core/state/pieces.hpp"

#include <vector>

// Rows of particles and bonds that change their places between windows: rock leaves (removal.hpp), broken rocks are
// divided (division.hpp). On the host.

namespace gyro {

/// Where particles go.
struct NewPlaces {
  std::vector<Index> new_index;  ///< of every particle before; none for those that leave
  std::vector<Index> old_index;  ///< of those that stay
};

/// Bonds and blocks before.
struct OldBonds {
  const std::vector<Index>&i, &j;
  const std::vector<std::int32_t>& state;
  const std::vector<Block>& blocks;
  Colours colours;
};

/// Bonds and blocks after.
struct NewBonds {
  std::vector<Index> i, j;
  std::vector<std::int32_t> state;
  std::vector<Index> source;  ///< index of each bond before; none for those that fill up to the alignment
  std::vector<Index> colour_begin;
  std::vector<std::int32_t> colour_starts;
  std::vector<Block> blocks;
  std::vector<Index> old_block;  ///< of each block: its number before, or that of the block that it was a part of

  Index bond_count() const { return static_cast<Index>(source.size()); }

  /// Begins a block. @param like  what the block has in common with one before, with its new particles
  /// @param old  number of the one before
  void begin_block(const Block& like, Index old) {
    blocks.push_back(like);
    blocks.back().first_bond = bond_count();
    blocks.back().first_colour = static_cast<Index>(colour_begin.size());
    blocks.back().table_bonds = 0;
    old_block.push_back(old);
  }
  void begin_colour(std::int32_t starts) {
    colour_begin.push_back(bond_count());
    colour_starts.push_back(starts);
  }
  void add(Index from, Index first, Index second, std::int32_t with_state) {
    source.push_back(from);
    i.push_back(first);
    j.push_back(second);
    state.push_back(with_state);
  }
  /// Ends the block, whose last colour has none but its begin, and fills up to the alignment.
  void end_block() {
    Block& block = blocks.back();
    block.table_bonds = bond_count() - block.first_bond;
    while (source.size() % bond_alignment != 0) add(none, block.first_particle, block.first_particle, bond_broken);
    block.end_bond = bond_count();
    block.end_colour = static_cast<Index>(colour_begin.size());
  }
};

}  // namespace gyro
