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
  Index block;            ///< whose bonds are evaluated as well; none: no bonds
  std::int32_t substeps;  ///< of all its particles
};

/// Every particle of a scene in one piece, in their order.
struct Pieces {
  std::vector<Piece> together;    ///< rocks, each a piece, and loose particles
  std::vector<Piece> large_rows;  ///< particles of large rocks, without their bonds, rock by rock
  std::vector<Index> large;       ///< blocks of the large rocks
  int max_substeps = 1;           ///< of all pieces
};

/// Particles in a piece without bonds.
inline constexpr Index run_length = 128;
/// Bonds, rounded up to bond_alignment, from which on a rock is large: one thread's work on it would keep the others
/// waiting, and its state does not stay in a core's cache.
inline constexpr Index large_rock = 8192;

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

}  // namespace pieces_detail

/// @param blocks     in the order of their particles
/// @param particles  number of all particles; those outside of blocks have no sub-steps
inline Pieces make_pieces(const std::vector<Block>& blocks, Index particles) {
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
    if (b.end_bond - b.first_bond < large_rock) {
      pieces.together.push_back({b.first_particle, b.end_particle, static_cast<Index>(k), b.substeps});
    } else {
      pieces_detail::add_pieces(pieces.large_rows, {b.first_particle, b.end_particle, b.substeps});
      pieces.large.push_back(static_cast<Index>(k));
    }
    run = {b.end_particle, b.end_particle, 1};
  }
  extend(particles, 1);
  pieces_detail::add_pieces(pieces.together, run);
  return pieces;
}

}  // namespace gyro
