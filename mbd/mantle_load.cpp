// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/mantle_load.hpp"

namespace gyro {

void MantleWrench::add(const WallLoad& wall, double pivot_height) {
  work += wall.work;
  force += wall.force;
  torque += wall.torque - cross(Vec3d{0, 0, pivot_height}, wall.force);
}

MantleLoad mantle_load(const MantleWrench& rock, const Vec3d& axis, double bushing_depth) {
  MantleLoad load;
  load.work = rock.work;
  load.resisting_torque = -dot(rock.torque, Vec3d{0, 0, 1} - axis.z * axis);
  load.spin_torque = dot(rock.torque, axis);
  if (bushing_depth > 0) load.bearings = bearing_forces(rock.force, rock.torque, axis, bushing_depth);
  return load;
}

}  // namespace gyro
