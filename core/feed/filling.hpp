// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/feed/feed.hpp"
#include "core/feed/pieces.hpp"
#include "core/feed/region.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace gyro {

/// A chamber that is filled at t = 0 with pieces near given points.
struct ChamberFilling {
  std::vector<Piece> pieces;  ///< of the library
  ChamberRegion chamber;
  double clearance = 1e-4;  ///< minimum gap to other spheres and walls [m]
  int positions = 32;       ///< tried for each piece in each search
  std::uint64_t seed = 0;
  RockId first_rock = 0;          ///< number of the first piece
  ParticleId first_particle = 0;  ///< id of its first particle
};

/// Numbers of what a filling places if all of it finds room.
struct FillingCounts {
  std::int64_t particles = 0, bonds = 0;
  double mass = 0, singles_mass = 0;  ///< [kg]
};
FillingCounts counts_of(const ChamberFilling& filling, const RockLibrary& library);

/// What has been placed.
struct Filled {
  std::vector<NewRock> rocks;  ///< by number; single particles belong to no rock
  double mass = 0;             ///< placed [kg]
  double lost_mass = 0;        ///< of pieces that found no room [kg]
  std::int64_t lost = 0;       ///< number of them
  double shift = 0;            ///< mean distance of a piece from its target, by mass [m]
  double rise = 0;             ///< mean height of a piece above its target, by mass [m]
};

/// Places the pieces, the heaviest first, so that the small ones take the room that is left between the large ones.
///
/// A piece tries random orientations and positions around its target, in a circle that grows to its own radius, and
/// takes the one nearest to the target; a position is the lowest free height from the target on, or from up to its
/// radius below, with at least `clearance` to all spheres and walls. If none is nearer than twice its radius, it tries
/// a circle of four times its radius, and then the whole section of the chamber at the height of the target and above.
/// What finds no room there is lost. Pieces do not rotate.
/// @param poses     of the walls at t = 0
/// @param present   particles in the scene
/// @param strength  empty: the factor is 1 for every bond
Filled fill(const RockLibrary& library, const ChamberFilling& filling, std::span<const Wall> walls,
            std::span<const WallPose> poses, const ParticleSnapshot& present = {}, const BondStrength& strength = {});

}  // namespace gyro
