// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"

#include <vector>

namespace gyro {

/// Heights between which both liners of a chamber exist [m].
struct HeightRange {
  double low, high;
};

/// Radius of a liner's rock side by azimuth and height, cut out of its triangles by half-planes that begin at the
/// machine's axis. No symmetry is used: a liner may be out of round or beside the axis.
///
/// The number of half-planes has no divisor in common with the sectors of any usual mesh, so that the half-planes cut
/// facets at all positions between two corners. Between levels the radius is linear.
class RadialSections {
 public:
  enum class Face {
    innermost,
    outermost
  };  ///< which surface on a ray: innermost for a concave, outermost for a mantle
  static constexpr int azimuths = 97, levels = 1201;

  /// Levels without surface (holes, slanted edges) are interpolated between the nearest radii of their half-plane.
  /// @param lift  added to the mesh's heights [m]
  /// @throws BadInput if a half-plane cuts no surface between the heights
  RadialSections(const TriangleMesh& mesh, double lift, const HeightRange& heights, Face face);

  double at(int azimuth, double z) const;  ///< radius [m]
  double level(int k) const { return heights_.low + (heights_.high - heights_.low) * k / (levels - 1); }
  double bridged() const { return bridged_; }  ///< share of levels without surface

 private:
  struct Point {
    double r, z;
  };
  double& radius(int azimuth, int level) { return radius_[static_cast<std::size_t>(azimuth * levels + level)]; }
  void cut(const Vec3d* corner, int azimuth, const Vec3d& across, Face face);
  void add_segment(int azimuth, const Point& a, const Point& b, Face face);
  int bridge(int azimuth);

  HeightRange heights_;
  std::vector<double> radius_;
  double bridged_ = 0;
};

}  // namespace gyro
