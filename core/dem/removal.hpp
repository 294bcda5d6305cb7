// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/expect.hpp"
#include "core/dem/new_rows.hpp"

#include <algorithm>
#include <span>
#include <vector>

// Rock leaves between windows: what refers to particles is renumbered on the host, columns are shortened in place. The
// order of particles and bonds never changes, so that sums keep their order.

namespace gyro {

/// Particles that stay when others leave.
struct Remaining : NewPlaces {
  /// @param id       of every particle before
  /// @param leaving  ids, in any order
  Remaining(const std::vector<ParticleId>& id, std::span<const ParticleId> leaving) {
    new_index.assign(id.size(), none);
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

namespace removal_detail {

/// Adds what stays of a block's bonds, colour by colour.
inline void add_bonds(NewBonds& to, const OldBonds& old, const Block& block, const Remaining& remaining) {
  const auto at = [](const auto& v, Index k) { return v[static_cast<std::size_t>(k)]; };
  for (Index c = block.first_colour; c < block.end_colour; ++c) {
    to.begin_colour(at(old.colours.starts, c));
    if (c + 1 == block.end_colour) break;
    for (Index n = at(old.colours.begin, c); n < at(old.colours.begin, c + 1); ++n) {
      const Index first = at(remaining.new_index, at(old.i, n)), second = at(remaining.new_index, at(old.j, n));
      if (at(old.state, n) != bond_broken && first != none && second != none)
        to.add(n, first, second, at(old.state, n));
    }
  }
}

/// The table of a rock holds for all of it.
inline void forget_table(Block& now, const Block& before) {
  const auto particles = [](const Block& b) { return b.end_particle - b.first_particle; };
  if (now.table_bonds == before.table_bonds && particles(now) == particles(before)) return;
  GYRO_EXPECT(!now.rigid);  // what is rigid leaves as a whole
  now.table = none;
}

}  // namespace removal_detail

/// Bonds of the particles that stay, block by block in their order, without broken ones.
inline NewBonds kept_bonds(const OldBonds& old, const Remaining& remaining) {
  NewBonds kept;
  for (std::size_t k = 0; k < old.blocks.size(); ++k) {
    Block b = old.blocks[k];
    b.first_particle = remaining.place(b.first_particle);
    b.end_particle = remaining.place(b.end_particle);
    if (b.first_particle == b.end_particle) continue;
    kept.begin_block(b, static_cast<Index>(k));
    removal_detail::add_bonds(kept, old, old.blocks[k], remaining);
    kept.end_block();
    removal_detail::forget_table(kept.blocks.back(), old.blocks[k]);
  }
  return kept;
}

}  // namespace gyro
