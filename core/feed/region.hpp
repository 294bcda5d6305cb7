// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"

#include <variant>
#include <vector>

namespace gyro {

/// Box with edges along x, y, z [m].
struct BoxRegion {
  Vec3d low, high;
};

/// Upright cylinder [m].
struct CylinderRegion {
  Vec3d base;  ///< centre of the lower face
  double radius, height;
};

/// Ring between two walls about the z axis, or the inside of one wall. Above the outer wall it continues as a cylinder
/// with the radius of that wall's opening.
struct ChamberRegion {
  Index outer;         ///< wall, the concave
  Index inner = none;  ///< wall, the mantle
  double low, high;    ///< heights [m]; `high` is the limit of the initial charge
};

/// Region in which rocks are inserted: every sphere of a rock lies inside.
using Region = std::variant<BoxRegion, CylinderRegion, ChamberRegion>;

/// Radius that a wall about the z axis of its body leaves free (outer) or fills (inner), by height in the body's
/// frame; from the profile, or from all triangles of a mesh.
class RadiusByHeight {
 public:
  enum class Side { outer, inner };  ///< rock is inside (concave) or around (mantle)

  /// @throws BadInput if the wall is a plane, which has no radius about the z axis
  RadiusByHeight(const Wall& wall, Side side);

  /// Radius at a height [m]. Outer: the smallest radius of the wall; beyond its ends, that of the end. Inner: the
  /// largest radius; 0 above the wall, the radius of its lower end below it.
  double at(double z) const;
  double low() const { return low_; }    ///< lower end of the wall [m]
  double high() const { return high_; }  ///< upper end of the wall [m]

 private:
  Side side_;
  double low_, high_;
  std::vector<double> radius_;  ///< of equal slices of height, on the safe side
};

/// Cylinder of the given height [m] that stands on the top edge of a liner and is as wide as its opening.
/// @throws BadInput if the wall is a plane, which has no radius about the z axis
CylinderRegion opening_above(const Wall& wall, double height);

}  // namespace gyro
