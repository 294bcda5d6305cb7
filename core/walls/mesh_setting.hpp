// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"
#include "core/walls/nearest.hpp"

#include <vector>

namespace gyro {

/// Closed and open side setting as they are on two meshes [m].
struct MeshSetting {
  double closed = 0, open = 0;
};

/// The same on one side of the machine.
struct SideOfMeshes {
  double azimuth;       ///< [rad]
  double closed, open;  ///< least and largest gap over a gyration [m]
};

/// The gap between a mantle and a concave given as meshes, measured by turning the eccentric.
///
/// Points lie on the concave's lowest tenth above the discharge plane and on the mantle opposite, in strips of azimuth.
/// The gap of a strip is the shortest distance of its points to the other surface, there; over a gyration its
/// least is the closed side setting, its largest the open one. This is the definition of Liners, without use of any
/// symmetry; what lies between points of two edges is missed, by less than a hundredth of a millimetre here.
class MeshGap {
 public:
  /// @param mantle  as it stands with its axis upright
  /// @throws BadInput when the concave has nothing above the discharge plane
  MeshGap(const MeshShape& mantle, const MeshShape& concave, const GyrationMotion& motion);

  /// Turns the eccentric once: least closed and largest open setting of every fourth strip.
  MeshSetting measure(double lift) const;
  /// Turns the eccentric once: each strip by itself.
  std::vector<SideOfMeshes> sides(double lift) const;
  /// Closed side setting alone: strips on the closed side.
  double closed(double lift) const;
  /// Lift that gives the closed side setting, within 1e-6 m.
  /// @throws BadInput when no lift within half the concave's height does
  double solve_lift(double closed_side_setting) const;

 private:
  struct Strip {
    double azimuth;
    std::vector<Vec3d> concave, mantle;  ///< the mantle's in its own frame
  };
  void take_points(const MeshShape& mesh, double low, double high, std::vector<Vec3d> Strip::*points);
  double gap_of_mantle(const Strip& strip, const WallPose& pose, double minimum) const;
  double widest_gap() const;
  SideOfMeshes side(const Strip& strip, double lift) const;
  double gap(const Strip& strip, double angle, double lift) const;

  MeshGrid mantle_, concave_;
  GyrationMotion motion_;
  double height_ = 0;  ///< of the concave above the discharge plane [m]
  std::vector<Strip> strips_;
  double reach_ = 0;  ///< a gap that is larger is told as this; none is, lifted by less than a tenth of the height [m]
};

}  // namespace gyro
