// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"

#include <vector>

namespace gyro {

/// Inner radius of the concave by height, between its lower edge and its rim. It distinguishes rock that leaves through
/// the discharge opening from rock that leaves over the rim.
///
/// Between the lower edge and the rim, a point is outside if it is farther from the axis than the concave's surface.
/// Below the lower edge the boundary is a cone of 45 degrees that begins a tenth of the edge's radius outside the edge:
/// rock that comes through the opening may move outwards as fast as it falls.
class ConcaveOutline {
 public:
  /// @param points  of the surface, in any order; at least two heights
  /// @throws BadInput if a point is not finite, or all have the same height
  explicit ConcaveOutline(std::vector<ProfilePoint> points);

  double rim() const { return points_.back().z; }    ///< height of the upper edge [m]
  double edge() const { return points_.front().z; }  ///< height of the lower edge [m]
  double radius(double z) const;                     ///< of the boundary at a height up to the rim [m]
  bool outside(
      const Vec3d& point) const;  ///< whether it is outside the boundary; above the rim, outside the rim's radius

 private:
  std::vector<ProfilePoint> points_;  ///< by ascending height
};

}  // namespace gyro
