// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/kernels/bounds.hpp"
#include "core/kernels/particle_lane.hpp"
#include "core/scene/scene.hpp"

namespace gyro {

/// Half of a step's change of velocities: v += dt/2 F/m, w += dt/2 M/I.
template <class D>
GYRO_HD void half_kick(const D& dt, const ForceAndTorque<D>& load, ParticleRow<D>& motion, ParticleRow<D>& angular) {
  motion.vector += (D(0.5) * dt / motion.number) * load.force;
  angular.vector += (D(0.5) * dt / angular.number) * load.torque;
}

/// First half of a velocity Verlet step: half a kick with the loads of the last step, then a drift.
/// Until the second half of the kick, the velocities are those of mid-step: forces that depend on them see v(n+1/2).
struct Move {
  ParticleView p;
  double dt;             ///< step of the scene, from one evaluation of contacts to the next [s]
  const Sphere* bounds;  ///< of particles: as long as none leaves its own the lists hold (bounds.hpp)
  std::int32_t* stale;   ///< set to 1 by any particle that does
  bool with_orientation;
  StepLimits limits;
  std::int32_t* limit_exceeded;  ///< set to 1 by any particle beyond them

  /// @param step             of these particles [s]
  /// @param load             of the last step
  /// @param motion, angular  at the end of the last step
  template <class Lanes, class D>
  GYRO_HD void operator()(const Lanes& lanes, const D& step, const ForceAndTorque<D>& load, ParticleRow<D> motion,
                          ParticleRow<D> angular) const {
    ParticleRow<D> sphere = lanes.load(p.position);
    half_kick(step, load, motion, angular);
    sphere.vector += step * motion.vector;
    if (with_orientation) lanes.store(p.orientation, rotated(lanes.load(p.orientation), angular.vector, step));

    lanes.store(p.motion, motion);
    lanes.store(p.angular_motion, angular);
    lanes.store(p.position, sphere);
    watch(lanes, sphere, motion, angular, seen_centre(sphere.vector, motion.vector, D(dt), step));
  }

  /// Raises the flags of particles that leave their bounds or exceed the limits.
  /// @param seen  their centres as contacts see them
  template <class Lanes, class D>
  GYRO_HD void watch(const Lanes& lanes, const ParticleRow<D>& sphere, const ParticleRow<D>& motion,
                     const ParticleRow<D>& angular, const Vec3<D>& seen) const {
    const ParticleRow<D> bound = lanes.load(bounds);
    const auto beyond_list = has_left(bound.vector, bound.number, seen, sphere.number);
    const D allowed = D(limits.speed_ratio) * sphere.number, dt2 = D(dt * dt);
    const auto fast = dt2 * norm2(motion.vector) > allowed * allowed;
    const auto spinning = dt2 * norm2(angular.vector) > D(limits.rotation * limits.rotation);
    const auto beyond_limits = fast | spinning;
    if (!lanes.any(beyond_list | beyond_limits)) return;
    if (lanes.any(beyond_list)) raise_flag(stale);
    if (lanes.any(beyond_limits)) raise_flag(limit_exceeded);
  }
};

}  // namespace gyro
