// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"

#include <span>
#include <vector>

namespace gyro {

/// One level of a crusher's chamber. Radii are for the centred mantle, before it is lifted.
struct LinerRow {
  double z;               ///< above the discharge plane [m]
  double mantle_radius;   ///< [m]
  double concave_radius;  ///< [m]
};

/// How the mantle is set and moved.
struct LinerSetting {
  double closed_side_setting;  ///< shortest distance of mantle and concave at the discharge [m]
  double eccentricity;         ///< half the throw, at the discharge plane [m]
  double pivot_height;         ///< of the mantle's pivot above the discharge plane [m]
  double collar = 0;           ///< height of an upright collar on the concave, which prevents spilling [m]
};

/// The walls of a crusher; profiles are straight between the rows.
struct Liners {
  std::vector<LinerRow> rows;
  LinerSetting setting;
  ProfileShape concave;   ///< rock inside; open at the top and at the discharge
  ProfileShape mantle;    ///< rock outside; a cone of 45 degrees on top, a flat bottom at the lowest level
  GyrationMotion motion;  ///< with the lift that gives the setting
};

/// Builds the walls and lifts the mantle to the setting.
/// @param rows  two or more, z ascending from 0 or below to above 0, mantle inside the concave
/// @throws BadInput if rows and setting do not form a chamber, or no lift gives the setting
Liners make_liners(std::span<const LinerRow> rows, const LinerSetting& setting);

/// Gap between mantle and concave for a lift, on the closed or the open side of the plane that holds both axes: the
/// shortest distance from the concave's lowest tenth (above z = 0) to the mantle [m]; -1 if they overlap. Both surfaces
/// are of revolution, so a gyration only rotates this section about z. Open - closed is 2 e0 minus the rise of the
/// tilted mantle's lip, e0 R / Lp (0.8 mm of 43.4 mm for a 62-75).
double side_setting(const Liners& liners, double lift, bool closed_side);

/// Lift that gives the closed side setting [m], within 1e-9 m. Lifting narrows the gap.
/// @throws BadInput if no lift gives it
double solve_lift(const Liners& liners);

/// Capacity of one level of the chamber.
struct LinerLevel {
  double z;         ///< [m]
  double area;      ///< of the annulus, centred mantle [m2]
  double drop;      ///< of a slice per gyration [m]
  double capacity;  ///< area x drop x gyrations per second [m3/s], bulk
};

/// Geometry of a chamber at its setting.
struct LinerReport {
  double closed_side_setting, open_side_setting;  ///< measured [m]
  double throw_at_discharge;                      ///< open - closed [m]
  double volume;                                  ///< between the liners [m3]
  double capacity;                                ///< minimum over the levels [m3/s], bulk
  double choke_height;                            ///< level of the minimum [m]
  std::vector<double> nip_angle;                  ///< between the liners on the closed side, at each row [rad]
};

/// Slice of a level. It is nipped at the closed gap C(z) and sinks by h until the open gap O(z - h) = C(z), but at most
/// by the free fall in half a gyration, g (pi/w)^2 / 2. Gaps are radial: R_concave - R_mantle
/// -+ e0 (1 - z/Lp).
/// @param speed    of the eccentric [rad/s], > 0
/// @param gravity  [m/s2]
LinerLevel slice_at(const Liners& liners, double z, double speed, double gravity);

/// Measures the chamber. The capacity is the minimum over all levels whose slice ends inside the chamber;
/// a slice nearer to the discharge than its drop leaves the chamber.
LinerReport measure(const Liners& liners, double speed, double gravity);

/// Triangles of a surface of revolution; the right-handed normal points to the rock. The mesh is closed if both ends of
/// the profile lie on the axis. @throws BadInput for fewer than 3 sectors
TriangleMesh revolve(const ProfileShape& shape, int sectors);

}  // namespace gyro
