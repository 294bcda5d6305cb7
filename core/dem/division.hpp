// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/new_rows.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

// Broken rocks are divided between windows, so that each piece is a block of its own. On the host.

namespace gyro {

/// A scene's rows after broken rocks have been divided.
struct DividedRocks {
  NewPlaces places;  ///< of all particles; empty if no rock was divided
  NewBonds bonds;    ///< in the order of their blocks

  bool any() const { return !bonds.blocks.empty(); }
};

/// Divides broken rocks. What bonds, intact or pressed, hold together becomes a block, without the broken bonds; the
/// particles of a rock that have no such bond share a last one. Particles change their places within their rock only:
/// pieces follow each other by their first particle. Rigid rocks, rocks that all threads share, and those that did not
/// come into the scene free of load stay as they are.
class Division {
 public:
  Division(const OldBonds& old, Index particles) : old_(old) {
    for (std::size_t k = 0; k < old.blocks.size(); ++k)
      if (may_be_divided(old.blocks[k])) find_pieces(static_cast<Index>(k));
    if (divided_.empty()) return;
    to_.places.old_index.reserve(static_cast<std::size_t>(particles));
    std::size_t next = 0;
    for (std::size_t k = 0; k < old.blocks.size(); ++k) {
      place_all_until(old.blocks[k].first_particle);
      if (next < divided_.size() && divided_[next].block == static_cast<Index>(k))
        divide(divided_[next++]);
      else
        copy(static_cast<Index>(k));
    }
    place_all_until(particles);
    rename_ends();
  }

  DividedRocks take() { return std::move(to_); }

 private:
  struct Divided {
    Index block;
    std::vector<Index> label;  ///< of each particle of the rock: the first one of its piece
  };

  static bool may_be_divided(const Block& b) {
    return b.free_of_load && !b.rigid && b.state == block_broken && b.first_bond < b.end_bond &&
           !is_large_rock(b.end_bond - b.first_bond);
  }
  bool is_broken(Index bond) const { return old_.state[static_cast<std::size_t>(bond)] == bond_broken; }
  /// Rows that fill up to the alignment name one particle twice.
  bool is_filler(Index bond) const {
    return old_.i[static_cast<std::size_t>(bond)] == old_.j[static_cast<std::size_t>(bond)];
  }

  void find_pieces(Index k) {
    const Block& block = old_.blocks[static_cast<std::size_t>(k)];
    std::vector<Index> label(static_cast<std::size_t>(block.end_particle - block.first_particle));
    std::iota(label.begin(), label.end(), 0);
    const auto root = [&](Index n) {
      while (label[static_cast<std::size_t>(n)] != n) n = label[static_cast<std::size_t>(n)];
      return n;
    };
    bool lost = false;
    for (Index b = block.first_bond; b < block.end_bond; ++b) {
      if (is_filler(b)) continue;
      lost = lost || is_broken(b);
      if (is_broken(b)) continue;
      const Index u = root(old_.i[static_cast<std::size_t>(b)] - block.first_particle),
                  v = root(old_.j[static_cast<std::size_t>(b)] - block.first_particle);
      label[static_cast<std::size_t>(std::max(u, v))] = std::min(u, v);
    }
    bool apart = false;
    for (Index n = 0; n < static_cast<Index>(label.size()); ++n) {
      label[static_cast<std::size_t>(n)] = root(n);  // of lower ones it is known
      apart = apart || label[static_cast<std::size_t>(n)] != 0;
    }
    if (lost || apart) divided_.push_back({k, std::move(label)});
  }

  void place_next(Index particle) { to_.places.old_index.push_back(particle); }
  void place_all_until(Index end) {
    for (Index n = static_cast<Index>(to_.places.old_index.size()); n < end; ++n) place_next(n);
  }

  void copy(Index k) {
    const Block& block = old_.blocks[static_cast<std::size_t>(k)];
    place_all_until(block.end_particle);
    to_.bonds.begin_block(block, k);
    for (Index c = block.first_colour; c < block.end_colour; ++c) {
      to_.bonds.begin_colour(old_.colours.starts[static_cast<std::size_t>(c)]);
      const bool spent = block.first_bond == block.end_bond;  // its colours may be those of bonds that it has no more
      if (c + 1 == block.end_colour || spent) continue;
      for (Index b = colour(c); b < colour(c + 1); ++b) add(b);
    }
    to_.bonds.end_block();
    to_.bonds.blocks.back().table_bonds = block.table_bonds;
  }

  void divide(const Divided& rock) {
    const Block& block = old_.blocks[static_cast<std::size_t>(rock.block)];
    const auto count = static_cast<Index>(rock.label.size());
    std::vector<std::vector<Index>> members(rock.label.size()), of_piece(rock.label.size());
    for (Index n = 0; n < count; ++n)
      members[static_cast<std::size_t>(rock.label[static_cast<std::size_t>(n)])].push_back(n);
    for (Index c = block.first_colour; c + 1 < block.end_colour; ++c)
      for (Index b = colour(c); b < colour(c + 1); ++b)
        if (!is_filler(b) && !is_broken(b)) of_piece[piece_of(rock, block, b)].push_back(b);
    std::vector<Index> loose;
    for (std::size_t p = 0; p < members.size(); ++p) {
      if (members[p].size() == 1) loose.push_back(members[p].front());
      if (members[p].size() < 2) continue;
      begin(rock.block, members[p]);
      add_piece(block, of_piece[p]);
    }
    if (loose.empty()) return;
    begin(rock.block, loose);
    to_.bonds.begin_colour(starts_colour);
    to_.bonds.end_block();
  }

  std::size_t piece_of(const Divided& rock, const Block& block, Index bond) const {
    const Index n = old_.i[static_cast<std::size_t>(bond)] - block.first_particle;
    return static_cast<std::size_t>(rock.label[static_cast<std::size_t>(n)]);
  }

  /// Begins the block of these particles of a rock.
  void begin(Index k, const std::vector<Index>& members) {
    Block block = old_.blocks[static_cast<std::size_t>(k)];
    const Index first_of_rock = block.first_particle;
    block.first_particle = static_cast<Index>(to_.places.old_index.size());
    for (const Index n : members) place_next(first_of_rock + n);
    block.end_particle = static_cast<Index>(to_.places.old_index.size());
    block.table = none;
    block.calm = 0;
    to_.bonds.begin_block(block, k);
  }

  /// Adds the bonds of a piece in the colours that they had, less those that are empty.
  void add_piece(const Block& rock, const std::vector<Index>& of_piece) {
    Index c = rock.first_colour, last = none;
    for (const Index b : of_piece) {
      while (b >= colour(c + 1)) ++c;
      if (c != last) to_.bonds.begin_colour(starts_colour);
      last = c;
      add(b);
    }
    to_.bonds.begin_colour(starts_colour);
    to_.bonds.end_block();
  }

  Index colour(Index c) const { return old_.colours.begin[static_cast<std::size_t>(c)]; }
  void add(Index bond) {
    const auto b = static_cast<std::size_t>(bond);
    to_.bonds.add(bond, old_.i[b], old_.j[b], old_.state[b]);
  }

  /// Ends of bonds have been old particles until here.
  void rename_ends() {
    to_.places.new_index.resize(to_.places.old_index.size());
    for (std::size_t n = 0; n < to_.places.old_index.size(); ++n)
      to_.places.new_index[static_cast<std::size_t>(to_.places.old_index[n])] = static_cast<Index>(n);
    for (std::size_t b = 0; b < to_.bonds.source.size(); ++b) {
      if (to_.bonds.source[b] == none) continue;  // fills up, and names a new particle
      to_.bonds.i[b] = to_.places.new_index[static_cast<std::size_t>(to_.bonds.i[b])];
      to_.bonds.j[b] = to_.places.new_index[static_cast<std::size_t>(to_.bonds.j[b])];
    }
  }

  const OldBonds& old_;
  std::vector<Divided> divided_;  ///< by block
  DividedRocks to_;
};

/// @param particles  number of all particles
inline DividedRocks divided_rocks(const OldBonds& old, Index particles) {
  return Division(old, particles).take();
}

}  // namespace gyro
