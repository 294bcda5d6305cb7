// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gyro {

/// A fragment of the hold-up of another run.
struct SourceFragment {
  Vec3d centre;             ///< of mass [m]
  double mass;              ///< [kg]
  double radius;            ///< of the sphere about the centre that has its volume [m]
  bool single = false;      ///< one particle
  bool whole = false;       ///< a rock of which no bond has failed
  Vec3d velocity{0, 0, 0};  ///< of the centre of mass [m/s]
};

/// A connected part of a rock of the library, and where it should lie.
struct Piece {
  Index rock;                         ///< number in the library
  std::vector<Index> particles = {};  ///< of the template, ascending; empty: all of them
  Vec3d target{0, 0, 0};              ///< of its centre of mass [m]
  double mass = 0;                    ///< [kg]
  Index bonds = 0;                    ///< number of them
  Vec3d velocity{0, 0, 0};            ///< that of its fragment [m/s]
};

/// Pieces of the library's rocks for the fragments of another run, one after the other from the lowest to the highest.
///
/// - A whole rock becomes the rock of the library with the nearest mass.
/// - Any other fragment becomes a connected part of a random rock that is at least as heavy: the particles nearest to a
///   random one of them.
/// - A single particle becomes single particles of the library, drawn so that all crumbled rock of the library would
///   give them.
/// What a piece is heavier or lighter than its fragment is carried over to the next fragment of the same kind above, so
/// that below any height the masses agree within one piece of each kind. A fragment that is much heavier than the
/// heaviest rock of the library becomes several pieces, and one that is lighter than half a particle only adds to the
/// next.
/// @param library    at least one rock, with bonds between particles of one rock only
/// @param fragments  in any order
/// @param first      number of the first piece, a key of the random draws
std::vector<Piece> pieces_of(const RockLibrary& library, std::span<const SourceFragment> fragments, std::uint64_t seed,
                             std::uint64_t first = 0);

/// A piece as a rock of its own: its particles with the bonds between them, about its centre of mass.
RockTemplate template_of(const RockTemplate& rock, const Piece& piece);

}  // namespace gyro
