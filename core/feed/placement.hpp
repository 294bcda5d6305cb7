// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/feed/bed.hpp"
#include "core/feed/region.hpp"
#include "core/feed/wall_distance.hpp"
#include "core/math/quat.hpp"
#include "core/rocks/rock_template.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gyro {

/// Where a rock lies: of its centre of mass.
struct RockPose {
  Vec3d position;
  Quatd orientation;
};

/// Unit quaternion, uniform over all rotations (Shoemake 1992, Graphics Gems III).
/// @param u, v, w  uniform in (0, 1)
Quatd uniform_turn(double u, double v, double w);

/// Walls as the placement of rocks needs them; made once.
class WallSet {
 public:
  WallSet(std::span<const Wall> walls, double largest_radius, double gap);

  /// Takes the walls where they are now. @param poses  one per wall
  void move(std::span<const WallPose> poses);
  /// Smallest distance of a point to any wall [m], see WallDistance.
  double distance(const Vec3d& point) const;
  const WallPose& pose(Index wall) const { return poses_[static_cast<std::size_t>(wall)]; }

 private:
  std::vector<WallDistance> walls_;
  std::vector<WallPose> poses_;
};

/// A region with what is needed to draw places in it and to ask whether spheres are inside.
class PlaceRegion {
 public:
  PlaceRegion(const Region& region, std::span<const Wall> walls);

  double low() const { return low_; }
  double high() const { return high_; }
  /// Largest sphere that the region can hold [m].
  double largest_radius() const;
  /// Smallest extent across or along z [m].
  double narrowest() const;
  /// Part of the plane z = 0 to draw from, for a rock that is expected at a height.
  /// @param u, v  uniform in (0, 1)
  Vec3d draw(double height, double u, double v) const;
  /// The height to try next for a sphere at this place: its own if it lies within the region's
  /// sides, infinite if it never will.
  double raised(const WallSet& walls, const Vec3d& centre, double radius) const;
  /// Corners of a box around the region.
  BoxRegion bounds() const;

 private:
  bool chamber_holds(const ChamberRegion& chamber, const WallSet& walls, const Vec3d& centre, double radius) const;

  Region region_;
  double low_, high_;
  std::optional<RadiusByHeight> outer_, inner_;
};

/// How hard to look for a place.
struct Search {
  std::uint64_t seed;
  std::uint64_t rock;     ///< number, keys the random draws
  int places;             ///< random places
  int improvements;       ///< small moves from the best
  std::uint32_t attempt;  ///< made before: other places are drawn in each
  double expected_top;    ///< places are drawn between the region's foot and this height [m]
};

/// Finds places for rocks among spheres, walls and a region's bounds.
class Placement {
 public:
  Placement(const PlaceRegion& region, const WallSet& walls, const Bed& bed, double gap)
      : region_(region), walls_(walls), bed_(bed), gap_(gap) {}

  /// The lowest of many random places, improved by small moves: shifts and turns that let the
  /// rock sink. None if no place was free.
  std::optional<RockPose> lowest(const RockTemplate& rock, const Search& search) const;

  /// Lowest free height of the rock's centre at (x, y), up to a limit; infinite if there is none.
  /// Every sphere that is in the way raises the rock by the least that can free it, so no
  /// free height is passed over (at walls: by more than the gap).
  double lowest_height(const RockTemplate& rock, double x, double y, const Quatd& orientation, double limit) const;

 private:
  double raised(const Vec3d& centre, double radius) const;

  const PlaceRegion& region_;
  const WallSet& walls_;
  const Bed& bed_;
  double gap_;
};

}  // namespace gyro
