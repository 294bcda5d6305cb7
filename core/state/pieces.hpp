// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only: make_pieces().
#include "core/base/index_range.hpp"
#include "core/state/bonds.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace gyro {

/// Particles that are moved together with the bonds between them: a rock, or a run of particles without bonds.
struct Piece {
  Index first_particle, end_particle;
  Index block;            ///< whose bonds are evaluated as well; none: no bonds
  std::int32_t substeps;  ///< of all its particles
};

/// What starts with a colour of a block.
enum ColourStart : std::int32_t {
  starts_colour = 0,  ///< nothing more
  starts_part = 1,    ///< a part of a large rock
  starts_round = 2    ///< its first part that shares a particle with one before
};

/// The colours of all blocks. A block has one entry more than colours.
struct Colours {
  const std::vector<Index>& begin;          ///< first bond of each
  const std::vector<std::int32_t>& starts;  ///< ColourStart of each
};

/// Bonds of a large rock that one thread works on, or one thread block of a GPU.
struct Part {
  Index first_bond, end_bond;
  Index first_colour, end_colour;  ///< their range in the array of colour begins
};

/// A rock whose bonds all threads share: the parts of a round at the same time, one round after the other.
struct LargeRock {
  Index block;
  std::int32_t substeps;
  IndexRange rows;                 ///< pieces of its particles, in Pieces::large_rows
  std::vector<IndexRange> rounds;  ///< of Pieces::parts
};

/// Every particle of a scene in one piece, in their order.
struct Pieces {
  std::vector<Piece> together;    ///< rocks, each a piece, and loose particles
  std::vector<Piece> large_rows;  ///< particles of large rocks, without their bonds, rock by rock
  std::vector<Part> parts;        ///< bonds of large rocks, rock by rock
  std::vector<LargeRock> large;
  int max_substeps = 1;  ///< of all pieces
};

/// Particles in a piece without bonds.
inline constexpr Index run_length = 128;
/// Bonds, rounded up to bond_alignment, from which on a rock is large: one thread's work on it would keep the others
/// waiting, and its state does not stay in a core's cache.
inline constexpr Index large_rock = 8192;
/// @param bonds  of a rock, rounded up to bond_alignment or not
constexpr bool is_large_rock(Index bonds) {
  return bonds > large_rock - bond_alignment;
}

namespace pieces_detail {

/// Particles that follow each other, without bonds and with the same sub-steps.
struct Run {
  Index first, end;
  std::int32_t substeps;
};

inline void add_pieces(std::vector<Piece>& to, const Run& run) {
  for (Index first = run.first; first < run.end; first += run_length)
    to.push_back({first, std::min(run.end, first + run_length), none, run.substeps});
}

/// The parts of a large rock, and their rounds.
inline void add_parts(Pieces& to, LargeRock& rock, const Block& block, const Colours& colours) {
  const auto first_bond = [&](Index colour) { return colours.begin[static_cast<std::size_t>(colour)]; };
  Index first = block.first_colour;
  for (Index end = first + 1; end < block.end_colour; ++end) {
    if (end + 1 < block.end_colour && colours.starts[static_cast<std::size_t>(end)] == starts_colour) continue;
    const Index place = static_cast<Index>(to.parts.size());
    if (rock.rounds.empty() || colours.starts[static_cast<std::size_t>(first)] == starts_round)
      rock.rounds.push_back({place, place});
    if (first_bond(first) < first_bond(end)) {
      to.parts.push_back({first_bond(first), first_bond(end), first, end});
      ++rock.rounds.back().end;
    }
    first = end;
  }
}

inline void add_large_rock(Pieces& to, Index number, const Block& block, const Colours& colours) {
  LargeRock rock{number, block.substeps, {static_cast<Index>(to.large_rows.size()), 0}, {}};
  add_pieces(to.large_rows, {block.first_particle, block.end_particle, block.substeps});
  rock.rows.end = static_cast<Index>(to.large_rows.size());
  add_parts(to, rock, block, colours);
  to.large.push_back(std::move(rock));
}

}  // namespace pieces_detail

/// @param blocks     in the order of their particles
/// @param particles  number of all particles; those outside of blocks have no sub-steps
inline Pieces make_pieces(const std::vector<Block>& blocks, const Colours& colours, Index particles) {
  Pieces pieces;
  pieces_detail::Run run{0, 0, 1};  // not added yet
  const auto extend = [&](Index end, std::int32_t substeps) {
    if (end > run.end && substeps != run.substeps) {
      pieces_detail::add_pieces(pieces.together, run);
      run = {run.end, run.end, substeps};
    }
    run.end = std::max(run.end, end);
  };
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Block& b = blocks[k];
    pieces.max_substeps = std::max(pieces.max_substeps, static_cast<int>(b.substeps));
    extend(b.first_particle, 1);
    if (b.first_bond == b.end_bond) {
      extend(b.end_particle, b.substeps);
      continue;
    }
    pieces_detail::add_pieces(pieces.together, run);
    if (!is_large_rock(b.end_bond - b.first_bond)) {
      pieces.together.push_back({b.first_particle, b.end_particle, static_cast<Index>(k), b.substeps});
    } else {
      pieces_detail::add_large_rock(pieces, static_cast<Index>(k), b, colours);
    }
    run = {b.end_particle, b.end_particle, 1};
  }
  extend(particles, 1);
  pieces_detail::add_pieces(pieces.together, run);
  return pieces;
}

}  // namespace gyro
