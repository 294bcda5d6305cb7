// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"
#include "core/state/pieces.hpp"

#include <algorithm>
#include <span>
#include <vector>

// Rock leaves between windows: what refers to particles is renumbered on the host, columns are shortened in place. The
// order of particles and bonds never changes, so that sums keep their order.

namespace gyro {

/// Particles that stay when others leave.
struct Remaining {
  std::vector<Index> new_index;  ///< of every particle before; none for those that leave
  std::vector<Index> old_index;  ///< of those that stay

  /// @param id       of every particle before
  /// @param leaving  ids, in any order
  Remaining(const std::vector<ParticleId>& id, std::span<const ParticleId> leaving) : new_index(id.size(), none) {
    std::vector<ParticleId> sorted(leaving.begin(), leaving.end());
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t n = 0; n < id.size(); ++n) {
      if (std::binary_search(sorted.begin(), sorted.end(), id[n])) continue;
      new_index[n] = static_cast<Index>(old_index.size());
      old_index.push_back(static_cast<Index>(n));
    }
  }

  /// First particle that stays from an old index on, by its new index.
  Index place(Index old) const {
    GYRO_EXPECT(old >= 0 && old <= static_cast<Index>(new_index.size()));
    return static_cast<Index>(std::lower_bound(old_index.begin(), old_index.end(), old) - old_index.begin());
  }
};

/// Bonds and blocks before some particles leave.
struct OldBonds {
  const std::vector<Index>&i, &j;
  const std::vector<std::int32_t>& state;
  const std::vector<Block>& blocks;
  Colours colours;
};

/// Bonds of the particles that stay, block by block in their order, without broken ones.
class KeptBonds {
 public:
  KeptBonds(const OldBonds& old, const Remaining& remaining) : new_block(old.blocks.size(), none) {
    for (std::size_t k = 0; k < old.blocks.size(); ++k) {
      Block b = old.blocks[k];
      b.first_particle = remaining.place(b.first_particle);
      b.end_particle = remaining.place(b.end_particle);
      if (b.first_particle == b.end_particle) continue;
      b.first_bond = static_cast<Index>(source.size());
      b.first_colour = static_cast<Index>(colour_begin.size());
      add_bonds(old, old.blocks[k], remaining, b.first_particle);
      b.end_bond = static_cast<Index>(source.size());
      b.end_colour = static_cast<Index>(colour_begin.size());
      new_block[k] = static_cast<Index>(blocks.size());
      blocks.push_back(b);
    }
  }

  std::vector<Index> i, j;
  std::vector<std::int32_t> state;
  std::vector<Index> source;  ///< index of each bond before; none for those that fill up to the alignment
  std::vector<Index> colour_begin;
  std::vector<std::int32_t> colour_starts;
  std::vector<Block> blocks;
  std::vector<Index> new_block;  ///< of every block before; none for those that leave

 private:
  void add(Index from, Index first, Index second, std::int32_t with_state) {
    source.push_back(from);
    i.push_back(first);
    j.push_back(second);
    state.push_back(with_state);
  }

  /// Adds what stays of a block's bonds, colour by colour, and fills up to the alignment.
  /// @param filler  particle that bonds which fill up name as their ends
  void add_bonds(const OldBonds& old, const Block& block, const Remaining& remaining, Index filler) {
    const auto at = [](const auto& v, Index k) { return v[static_cast<std::size_t>(k)]; };
    for (Index c = block.first_colour; c < block.end_colour; ++c) {
      colour_begin.push_back(static_cast<Index>(source.size()));
      colour_starts.push_back(at(old.colours.starts, c));
      if (c + 1 == block.end_colour) break;
      for (Index n = at(old.colours.begin, c); n < at(old.colours.begin, c + 1); ++n) {
        const Index first = at(remaining.new_index, at(old.i, n)), second = at(remaining.new_index, at(old.j, n));
        if (at(old.state, n) != bond_broken && first != none && second != none) add(n, first, second, at(old.state, n));
      }
    }
    while (source.size() % bond_alignment != 0) add(none, filler, filler, bond_broken);
  }
};

}  // namespace gyro
