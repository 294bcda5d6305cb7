// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/shared_counter.hpp"
#include "core/dem/scene.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// First half of a velocity Verlet step: half a kick with the loads of the last step, then a drift.
/// Until Gather has given the second half, the velocities are those of mid-step: forces that depend
/// on them see v(n+1/2).
struct Move {
  ParticleView p;
  double dt;            ///< [s]
  double ahead;         ///< as in seen(): lists must hold for the places that contacts see [s]
  double allowed2;      ///< square of the way a particle may go before lists are stale [m2]
  std::int32_t* stale;  ///< set to 1 by any particle that went further
  bool with_turn;
  double look;  ///< time from one look at contacts to the next [s]
  StepLimits limits;
  std::int32_t* passed;  ///< set to 1 by any particle beyond them

  GYRO_HD void operator()(Index n) const {
    Sphere place = p.place[n];
    Motion motion = p.motion[n];
    Spin spin = p.spin[n];
    const Load load = p.load[n];

    motion.v += (0.5 * dt / motion.mass) * load.force;
    spin.w += (0.5 * dt / spin.inertia) * load.moment;
    place.x += dt * motion.v;
    if (with_turn) p.turn[n] = turned(p.turn[n], spin.w, dt);

    p.motion[n] = motion;
    p.spin[n] = spin;
    p.place[n] = place;
    if (norm2(place.x + ahead * motion.v - p.listed_at[n]) > allowed2) raise_flag(stale);
    const double way = limits.speed_ratio * place.radius;
    if (look * look * norm2(motion.v) > way * way || look * look * norm2(spin.w) > limits.turn * limits.turn)
      raise_flag(passed);
  }
};

}  // namespace gyro
