// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"
#include "core/walls/nearest.hpp"

#include <vector>

namespace gyro {

/// Closed and open side setting of two meshes [m].
struct MeshSetting {
  double closed = 0, open = 0;
};

/// The same for one side of the machine.
struct SideOfMeshes {
  double azimuth;       ///< [rad]
  double closed, open;  ///< smallest and largest gap over a gyration [m]
};

/// The gap between a mantle and a concave given as meshes, measured over a gyration.
///
/// Points lie on the concave's lowest tenth above the discharge plane and on the mantle opposite, in strips of azimuth.
/// The gap of a strip is the shortest distance of its points to the other surface in this zone; its minimum over a
/// gyration is the closed side setting, its maximum the open one. This is the definition of Liners without any
/// symmetry. On liners drawn as thick bodies only the surface towards the other liner has points. The error of the
/// spacing of points is below 0.01 mm for a 62-75.
class MeshGap {
 public:
  /// @param mantle  with its axis upright
  /// @throws BadInput if no part of the concave is above the discharge plane
  MeshGap(const TriangleMesh& mantle, const TriangleMesh& concave, const GyrationMotion& motion);

  /// Closed setting (minimum) and open setting (maximum) of every fourth strip over a turn of the eccentric.
  MeshSetting measure(double lift) const;
  /// Both settings of each strip over a turn of the eccentric.
  std::vector<SideOfMeshes> sides(double lift) const;
  /// Closed side setting alone [m], from each strip while it is on the closed side.
  double closed(double lift) const;
  /// Lift that gives the closed side setting, within 1e-6 m.
  /// @throws BadInput if no lift within half the concave's height gives it
  double solve_lift(double closed_side_setting) const;

 private:
  struct Strip {
    double azimuth;
    std::vector<Vec3d> concave, mantle;  ///< the mantle's in its own frame
  };
  enum class Side { inner, outer };  ///< side of a liner on which the rock is: inner for a concave, outer for a mantle
  void add_points(const TriangleMesh& mesh, double low, double high, std::vector<Vec3d> Strip::*points, Side side);
  double gap_of_mantle(const Strip& strip, const WallPose& pose, double minimum) const;
  double widest_gap() const;
  SideOfMeshes side(const Strip& strip, double lift) const;
  double gap(const Strip& strip, double angle, double lift) const;

  MeshGrid mantle_, concave_;
  GyrationMotion motion_;
  double height_ = 0;  ///< of the concave above the discharge plane [m]
  std::vector<Strip> strips_;
  double reach_ = 0;  ///< search radius; larger gaps are reported as this value [m]
};

}  // namespace gyro
