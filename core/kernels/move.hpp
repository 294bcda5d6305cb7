// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/kernels/bounds.hpp"
#include "core/scene/scene.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// Half of a step's change of velocities: v += dt/2 F/m, w += dt/2 M/I.
GYRO_HD inline void half_kick(double dt, const Load& load, Motion& motion, AngularMotion& angular) {
  motion.v += (0.5 * dt / motion.mass) * load.force;
  angular.w += (0.5 * dt / angular.inertia) * load.torque;
}

/// First half of a velocity Verlet step: half a kick with the loads of the last step, then a drift.
/// Until the second half of the kick, the velocities are those of mid-step: forces that depend on them see v(n+1/2).
struct Move {
  ParticleView p;
  double dt;            ///< step of the scene, from one evaluation of contacts to the next [s]
  const Sphere* bounds;  ///< of particles: as long as none leaves its own the lists hold (bounds.hpp)
  std::int32_t* stale;   ///< set to 1 by any particle that does
  bool with_orientation;
  StepLimits limits;
  std::int32_t* limit_exceeded;  ///< set to 1 by any particle beyond them

  /// @param step             of this particle [s]
  /// @param load             of the last step
  /// @param motion, angular  at the end of the last step
  GYRO_HD void operator()(Index n, double step, const Load& load, Motion motion, AngularMotion angular) const {
    Sphere sphere = p.position[n];
    half_kick(step, load, motion, angular);
    sphere.x += step * motion.v;
    if (with_orientation) p.orientation[n] = rotated(p.orientation[n], angular.w, step);

    p.motion[n] = motion;
    p.angular_motion[n] = angular;
    p.position[n] = sphere;
    if (has_left(bounds[n], seen_centre(sphere.x, motion.v, dt, step), sphere.radius)) raise_flag(stale);
    const double allowed = limits.speed_ratio * sphere.radius;
    if (dt * dt * norm2(motion.v) > allowed * allowed || dt * dt * norm2(angular.w) > limits.rotation * limits.rotation)
      raise_flag(limit_exceeded);
  }
};

}  // namespace gyro
