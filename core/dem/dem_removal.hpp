// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/dem_solver.hpp"

#include <algorithm>

// Rock goes between windows: what refers to particles is renumbered on the host, the columns are
// shortened where they are. The order of particles and bonds never changes: sums keep their order.

namespace gyro {

/// Bonds before some particles leave.
struct OldBonds {
  const Index *i, *j;
  const std::int32_t* state;
  const Index* colour_begin;
  const Index* new_index;  ///< of each particle, none for those that leave
};

/// Bonds that stay.
struct KeptBonds {
  std::vector<Index> i, j, colour_begin;
  std::vector<std::int32_t> state;
  std::vector<Index> source;  ///< place of each bond before, none for those that fill up

  void add(Index from, Index first, Index second, std::int32_t with_state) {
    source.push_back(from);
    i.push_back(first);
    j.push_back(second);
    state.push_back(with_state);
  }

  /// Adds what stays of a block's bonds, colour by colour, and fills up to the alignment.
  /// @param filler  particle that bonds which fill up name as their ends
  void add_block(const OldBonds& old, const Block& block, Index filler) {
    for (Index c = block.first_colour; c < block.end_colour; ++c) {
      colour_begin.push_back(static_cast<Index>(source.size()));
      if (c + 1 == block.end_colour) break;
      for (Index n = old.colour_begin[c]; n < old.colour_begin[c + 1]; ++n) {
        const Index first = old.new_index[old.i[n]], second = old.new_index[old.j[n]];
        if (old.state[n] != bond_broken && first != none && second != none) add(n, first, second, old.state[n]);
      }
    }
    while (source.size() % bond_alignment != 0) add(none, filler, filler, bond_broken);
  }
};

template <class Exec, class Real>
void DemSolver<Exec, Real>::remove(std::span<const ParticleId> ids) {
  if (ids.empty()) return;
  const Remaining remaining = without(ids);
  const EnergyTerms before = energy();
  const BondSums bonds_before = bond_sums();
  book_walls();
  keep_pairs(remaining);
  keep_walls(remaining);
  keep_bonds(remaining);
  keep_particles(remaining);
  if (has_bonds()) index_bonds();
  listed_ = false;

  counts_total_.bonds_intact -= bonds_before.intact - bond_sums().intact;
  const EnergyTerms after = energy();
  const auto state = [](const EnergyTerms& e) { return e.kinetic + e.potential + e.contact_elastic + e.bond_elastic; };
  booked_.exchanged -= state(before) - state(after);
}

template <class Exec, class Real>
auto DemSolver<Exec, Real>::without(std::span<const ParticleId> ids) const -> Remaining {
  std::vector<ParticleId> leaving(ids.begin(), ids.end());
  std::sort(leaving.begin(), leaving.end());
  const auto& id = Exec::host(particles_.id);
  Remaining remaining;
  remaining.new_index.assign(id.size(), none);
  for (std::size_t n = 0; n < id.size(); ++n) {
    if (std::binary_search(leaving.begin(), leaving.end(), id[n])) continue;
    remaining.new_index[n] = static_cast<Index>(remaining.old_index.size());
    remaining.old_index.push_back(static_cast<Index>(n));
  }
  return remaining;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_particles(const Remaining& remaining) {
  const auto& losses = Exec::host(particles_.losses);
  for (std::size_t n = 0; n < losses.size(); ++n) {
    if (remaining.new_index[n] != none) continue;
    const LostWork& lost = losses[n];
    booked_.bond_damping += lost.bond_damping;
    booked_.contact_damping += lost.contact_damping;
    booked_.friction += lost.bond_slip + lost.contact_slip;
  }
  for_each_particle_column(
      [&](const char*, bool needs_bonds, auto& column) {
        if (!needs_bonds || has_bonds()) Exec::keep(column, remaining.old_index);
      },
      particles_);
}

/// Bonds of the particles that stay, block by block in their order; gone ones are left out.
template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_bonds(const Remaining& remaining) {
  const auto& old_blocks = Exec::host(blocks_);
  const auto place = [&stay = remaining.old_index](Index particle) {
    return static_cast<Index>(std::lower_bound(stay.begin(), stay.end(), particle) - stay.begin());
  };
  const auto& i = Exec::host(bonds_.i);
  const auto& j = Exec::host(bonds_.j);
  const auto& state = Exec::host(bonds_.state);
  const auto& colour_begin = Exec::host(colour_begin_);
  const OldBonds old{i.data(), j.data(), state.data(), colour_begin.data(), remaining.new_index.data()};
  KeptBonds kept;
  Host<Block> blocks;
  Host<Index> new_block(old_blocks.size(), none);
  for (std::size_t k = 0; k < old_blocks.size(); ++k) {
    Block b = old_blocks[k];
    b.first_particle = place(b.first_particle);
    b.end_particle = place(b.end_particle);
    if (b.first_particle == b.end_particle) continue;
    b.first_bond = static_cast<Index>(kept.source.size());
    b.first_colour = static_cast<Index>(kept.colour_begin.size());
    kept.add_block(old, old_blocks[k], b.first_particle);
    b.end_bond = static_cast<Index>(kept.source.size());
    b.end_colour = static_cast<Index>(kept.colour_begin.size());
    new_block[k] = static_cast<Index>(blocks.size());
    blocks.push_back(b);
  }
  Host<Index> block = Exec::host(particles_.block);
  for (Index& b : block)
    if (b != none) b = new_block[static_cast<std::size_t>(b)];
  for_each_bond_column([&](const char*, auto& column) { Exec::keep(column, kept.source); }, bonds_);
  Exec::upload(bonds_.i, std::move(kept.i));
  Exec::upload(bonds_.j, std::move(kept.j));
  Exec::upload(bonds_.state, std::move(kept.state));
  Exec::upload(particles_.block, std::move(block));
  Exec::upload(blocks_, std::move(blocks));
  Exec::upload(colour_begin_, std::move(kept.colour_begin));
}

/// Pairs of the particles that stay, with their memory, under the new numbers.
template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_pairs(const Remaining& remaining) {
  const auto& pairs = Exec::host(pairs_.pairs);
  const auto& ends = Exec::host(pairs_.ends);
  const auto& row_begin = Exec::host(pairs_.row_begin);
  Host<Pair> kept;
  Host<Index> source, new_pair(pairs.size(), none);
  for (std::size_t n = 0; n < pairs.size(); ++n) {
    const Index i = remaining.new_index[static_cast<std::size_t>(pairs[n].i)],
                j = remaining.new_index[static_cast<std::size_t>(pairs[n].j)];
    if (i == none || j == none) continue;
    new_pair[n] = static_cast<Index>(kept.size());
    kept.push_back({i, j, none});  // the bond is found again when the lists are rebuilt
    source.push_back(static_cast<Index>(n));
  }
  Host<PairEnd> kept_ends;
  Host<Index> rows(1, 0);
  for (const Index old : remaining.old_index) {
    const auto n = static_cast<std::size_t>(old);
    for (Index e = row_begin[n]; e < row_begin[n + 1]; ++e) {
      const PairEnd end = ends[static_cast<std::size_t>(e)];
      const Index pair = new_pair[static_cast<std::size_t>(end.pair)];
      if (pair != none) kept_ends.push_back({pair, end.side});
    }
    rows.push_back(static_cast<Index>(kept_ends.size()));
  }
  Exec::keep(pairs_.history, source);
  Exec::keep(pairs_.result, source);
  Exec::keep(pairs_.touching, source);
  Exec::upload(pairs_.pairs, std::move(kept));
  Exec::upload(pairs_.ends, std::move(kept_ends));
  Exec::upload(pairs_.row_begin, std::move(rows));
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_walls(const Remaining& remaining) {
  const auto& entries = Exec::host(walls_.entries);
  const auto& row_begin = Exec::host(walls_.row_begin);
  Host<WallEntry> kept;
  Host<Index> source, rows(1, 0);
  for (std::size_t k = 0; k < remaining.old_index.size(); ++k) {
    const auto n = static_cast<std::size_t>(remaining.old_index[k]);
    for (Index e = row_begin[n]; e < row_begin[n + 1]; ++e) {
      WallEntry entry = entries[static_cast<std::size_t>(e)];
      entry.particle = static_cast<Index>(k);
      kept.push_back(entry);
      source.push_back(e);
    }
    rows.push_back(static_cast<Index>(kept.size()));
  }
  Exec::keep(walls_.history, source);
  Exec::keep(walls_.result, source);
  Exec::keep(walls_.touching, source);
  Exec::keep(walls_.sums, source);
  Exec::upload(walls_.entries, std::move(kept));
  Exec::upload(walls_.row_begin, std::move(rows));
}

}  // namespace gyro
