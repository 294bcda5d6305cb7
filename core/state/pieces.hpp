// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only: make_pieces().
#include "core/state/bonds.hpp"

#include <algorithm>
#include <vector>

namespace gyro {

/// Particles that are moved together with the bonds between them: a rock, or a run of particles without bonds.
struct Piece {
  Index first_particle, end_particle;
  Index block;  ///< whose bonds are evaluated as well; none: no bonds
};

/// Every particle of a scene in one piece, in their order.
struct Pieces {
  std::vector<Piece> together;    ///< rocks, each a piece, and loose particles
  std::vector<Piece> large_rows;  ///< particles of large rocks, without their bonds
  std::vector<Index> large;       ///< blocks of the large rocks
};

/// Particles in a piece without bonds.
inline constexpr Index run_length = 128;
/// Bonds, rounded up to bond_alignment, from which on a rock is large: one thread's work on it would keep the others
/// waiting, and its state does not stay in a core's cache.
inline constexpr Index large_rock = 8192;

/// @param blocks     in the order of their particles
/// @param particles  number of all particles
inline Pieces make_pieces(const std::vector<Block>& blocks, Index particles) {
  Pieces pieces;
  const auto add_runs = [](std::vector<Piece>& to, Index begin, Index end) {
    for (; begin < end; begin += run_length) to.push_back({begin, std::min(end, begin + run_length), none});
  };
  Index next = 0;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Block& b = blocks[k];
    if (b.first_bond == b.end_bond) continue;
    add_runs(pieces.together, next, b.first_particle);
    if (b.end_bond - b.first_bond < large_rock) {
      pieces.together.push_back({b.first_particle, b.end_particle, static_cast<Index>(k)});
    } else {
      add_runs(pieces.large_rows, b.first_particle, b.end_particle);
      pieces.large.push_back(static_cast<Index>(k));
    }
    next = b.end_particle;
  }
  add_runs(pieces.together, next, particles);
  return pieces;
}

}  // namespace gyro
