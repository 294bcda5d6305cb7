// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/feed/triangle_distance.hpp"
#include "core/scene/scene.hpp"

#include <vector>

namespace gyro {

/// Distance of points to one wall, for the placement of rocks. Made once for all poses of the wall.
///
/// Planes and profiles have sides: behind them the distance is negative. Beyond the height of a profile, and everywhere
/// for a mesh, it is positive.
class WallDistance {
 public:
  /// @param reach  larger distances are reported as this value [m]
  WallDistance(const Wall& wall, double reach);

  /// Distance of a world point to the wall, limited to +-reach [m]. If the point moves by s it changes by at most s,
  /// except for a jump at the ends of a profile.
  double at(const WallPose& pose, const Vec3d& point) const;

 private:
  struct Segment {
    double r, z, dr, dz, length2;
    double low, high;  ///< heights
  };
  /// Segments that may be within reach of a slice of height, in their order.
  struct Slices {
    double low, per_metre;
    std::vector<Index> begin, segment;
  };
  struct Cells {
    Vec3d low;
    double size;
    Vec3<Index> count;
    std::vector<Index> begin, triangle;  ///< triangles that may be within reach of a cell
  };

  void make_profile(const ProfileShape& shape);
  void fill_slices();
  void make_mesh(const TriangleMesh& shape);
  void fill_cells();
  double to_profile(const Vec3d& body) const;
  double to_mesh(const Vec3d& body) const;

  double reach_;
  PlaneShape plane_{};
  std::vector<Segment> segments_;
  Slices slices_{};
  std::vector<FlatTriangle> triangles_;
  Cells cells_{};
};

}  // namespace gyro
