// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/feed/bed.hpp"
#include "core/feed/region.hpp"
#include "core/feed/wall_distance.hpp"
#include "core/math/quat.hpp"
#include "core/rocks/rock_template.hpp"

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace gyro {

/// Pose of a rock that is placed.
struct RockPose {
  Vec3d position;     ///< of the centre of mass [m]
  Quatd orientation;  ///< from the frame of the template to the world
};

/// Unit quaternion, uniform over all rotations (Shoemake 1992, Graphics Gems III).
/// @param u, v, w  uniform in (0, 1)
Quatd uniform_orientation(double u, double v, double w);

/// The walls with their distances, for the placement of rocks; made once.
class WallSet {
 public:
  /// @param largest_radius  of any particle [m]
  /// @param gap             minimum distance of spheres and walls [m]
  WallSet(std::span<const Wall> walls, double largest_radius, double gap);

  /// Moves the walls to these poses, one per wall.
  void move(std::span<const WallPose> poses);
  /// Smallest distance of a point to any wall [m], see WallDistance.
  double distance(const Vec3d& point) const;
  const WallPose& pose(Index wall) const { return poses_[static_cast<std::size_t>(wall)]; }

 private:
  std::vector<WallDistance> walls_;
  std::vector<WallPose> poses_;
};

/// A region for placement: draws positions in it and checks whether spheres are inside.
class FeedRegion {
 public:
  FeedRegion(const Region& region, std::span<const Wall> walls);

  double low() const { return low_; }    ///< height of its foot [m]
  double high() const { return high_; }  ///< height of its top [m]
  /// Radius of the largest sphere that fits into the region [m].
  double largest_radius() const;
  /// Smallest extent across or along z [m].
  double narrowest() const;
  /// A random point (x, y, 0) of the region's section at the height at which the rock is expected.
  /// @param u, v  uniform in (0, 1)
  Vec3d draw(double height, double u, double v) const;
  /// The height to try next for a sphere at this position [m]: its own height if it lies within the region's sides,
  /// infinity if it does not at any height.
  double raised(const WallSet& walls, const Vec3d& centre, double radius) const;
  /// Corners of a box around the region.
  BoxRegion bounds() const;

 private:
  bool chamber_holds(const ChamberRegion& chamber, const WallSet& walls, const Vec3d& centre, double radius) const;

  Region region_;
  double low_, high_;
  std::optional<RadiusByHeight> outer_, inner_;
};

/// Height of the rock that a charge has placed so far, in square cells as wide as the largest rock. What lies deep
/// below the surface is nearly full, and to search it again for each rock would take a time in proportion to the
/// height of the charge. Small rocks no longer reach holes there, so that a charge of widely distributed sizes may be
/// emptier below (README.md has what was measured).
class BedSurface {
 public:
  /// @param foot     of the charge [m]
  /// @param largest  diameter of the largest rock [m]
  BedSurface(const BoxRegion& bounds, double foot, double largest);
  void add(const Vec3d& centre, double radius);
  /// Height from which on a rock at (x, y) looks for room [m], with the diameter d of the largest rock: where the
  /// highest sphere of the cell ends more than deep * d above the foot, depth * d below that sphere's end; else the
  /// foot.
  double floor(double x, double y) const;

  static constexpr double deep = 4, depth = 2;

 private:
  std::size_t cell_of(double x, double y) const;

  Vec3d low_;
  double foot_, cell_;
  int along_x_, along_y_;    ///< number of cells
  std::vector<double> top_;  ///< highest sphere of each cell [m]
};

/// Effort and random numbers of a search for a position.
struct Search {
  std::uint64_t seed;
  std::uint64_t rock;                   ///< number of the rock, a key of the random draws
  int positions;                        ///< random positions
  int improvements;                     ///< small moves from the best
  std::uint32_t attempt;                ///< number of earlier attempts; each draws other positions
  double expected_top;                  ///< positions are drawn between the region's foot and this height [m]
  const BedSurface* surface = nullptr;  ///< of the charge; none: rocks look for room from the foot of the region on
};

/// Finds positions for rocks between spheres, walls and a region's bounds.
class Placement {
 public:
  /// @param gap  minimum distance of spheres and walls [m]; the other arguments must outlive the placement
  Placement(const FeedRegion& region, const WallSet& walls, const Bed& bed, double gap)
      : region_(region), walls_(walls), bed_(bed), gap_(gap) {}

  /// The lowest of many random positions, improved by small shifts and rotations that lower the rock. None if no
  /// position was free.
  std::optional<RockPose> lowest(const RockTemplate& rock, const Search& search) const;

  /// Lowest free height of the rock's centre at (x, y) with no sphere below `floor` (the region's foot where that is
  /// higher), up to a limit [m]; infinite if there is none.
  /// Every sphere in the way raises the rock by the smallest amount that can free it, so no
  /// free height is missed (at walls: by no more than the gap).
  double lowest_height(const RockTemplate& rock, double x, double y, const Quatd& orientation, double limit,
                       double floor = std::numeric_limits<double>::lowest()) const;

 private:
  double raised(const Vec3d& centre, double radius) const;

  const FeedRegion& region_;
  const WallSet& walls_;
  const Bed& bed_;
  double gap_;
};

}  // namespace gyro
