// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"
#include "core/scene/accounts.hpp"
#include "mbd/bearings.hpp"

namespace gyro {

/// Load of the rock on the drive in a window.
struct MantleLoad {
  double work = 0;  ///< done by the mantle on the rock [J]
  /// Mean torque T_c of the rock about the eccentric's axis, positive when it resists forward motion [N m]. The
  /// drivetrain uses it only while the mantle stands still, because the work is then 0 for any torque.
  double resisting_torque = 0;
  double spin_torque = 0;    ///< mean torque T_s of the rock on the mantle about the mantle's own axis [N m]
  BearingForces bearings{};  ///< [N]
};

/// Mean force and torque of the rock on the mantle over a window, summed over all walls that gyrate. World frame.
struct MantleWrench {
  Vec3d force{0, 0, 0};   ///< [N]
  Vec3d torque{0, 0, 0};  ///< M_O, about the pivot [N m]
  double work = 0;        ///< of the mantle on the rock in the window [J]

  /// Adds the load of one gyrating wall. @param pivot_height  the pivot is (0, 0, pivot_height) [m]
  void add(const WallLoad& wall, double pivot_height);
};

/// The load on the drive, by virtual work. The mantle's angular velocity is Omega = theta' (z - (z . u) u) + sigma u,
/// with the pivot at rest, so that the power of the rock on the mantle is
///
///   M_O . Omega = -T_c theta' + T_s sigma,   T_c = -M_O . (z - (z . u) u),   T_s = M_O . u
///
/// theta' and sigma: eccentric speed and spin [rad/s]; z: the machine's axis, pointing up. The axis u turns in the
/// window; taking it at mid-window is of second order in the window's length.
/// @param axis           u, the mantle's axis, unit, pointing up, world frame
/// @param bushing_depth  of the eccentric's bushings below the pivot [m]; 0: the forces on the bearings are left at 0
MantleLoad mantle_load(const MantleWrench& rock, const Vec3d& axis, double bushing_depth);

}  // namespace gyro
