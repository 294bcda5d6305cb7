// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/walls/mesh_setting.hpp"

#include <vector>

namespace gyro {

/// The liners of a crusher as meshes, at their setting.
struct MeshLiners {
  TriangleMesh concave, mantle;  ///< the mantle as drawn: upright, before it is lifted
  GyrationMotion motion;         ///< with the lift that gives the setting
};

/// Geometry of a chamber between meshes, by the definitions of LinerReport without its symmetry. The mantle does not
/// spin: its azimuths stay opposite to those of the concave as drawn.
struct MeshReport {
  double closed_side_setting;       ///< minimum over all sides [m]
  double open_side_setting;         ///< maximum over all sides [m]
  double throw_at_discharge;        ///< open - closed of one side, mean of all sides [m]
  std::vector<SideOfMeshes> sides;  ///< by azimuth
  double bottom,
      top;  ///< heights of the chamber's ends: between them both liners exist, at an angle of at most 45 degrees [m]
  double volume;        ///< between the liners from bottom to top, centred mantle [m3]
  double capacity;      ///< minimum over the levels, each summed over azimuth [m3/s], bulk
  double choke_height;  ///< level of the minimum [m]
  struct NipAngle {
    double z, minimum, largest;  ///< over azimuth, on the closed side [m], [rad], [rad]
  };
  std::vector<NipAngle> nip_angle;  ///< chords over a fiftieth of the chamber's height, upwards
  /// Share of the radii that were interpolated across gaps of the mesh: the larger one of mantle and concave [-].
  double bridged;
};

/// Measures the chamber: the settings over a gyration, everything else from sections by azimuth and height.
/// @param speed    of the eccentric [rad/s], > 0
/// @param gravity  [m/s2], > 0
/// @throws BadInput if there is no chamber between the liners
MeshReport measure(const MeshLiners& liners, double speed, double gravity);

}  // namespace gyro
