// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/friction.hpp"
#include "core/laws/contact/rolling.hpp"

namespace gyro {

/// A contact law: a normal law, Mindlin's friction with the stiffness that belongs to it, and a rolling law. A type, so
/// that a kernel is compiled for it: what a scene does not name costs nothing.
template <class NormalLaw, class RollingLaw>
struct ContactLaw {
  using Normal = NormalLaw;
  using Rolling = RollingLaw;
  static constexpr bool keeps_extra_history = Normal::keeps_extra_history || Rolling::keeps_extra_history;

  /// Loads of a contact.
  ///
  /// Work is force times displacement with the mean of the forces at both ends of the step, as velocity Verlet spends
  /// them; the damping force at the end alone would err by the first power of the step.
  /// @param c        kinematics; c.overlap > 0
  /// @param history  of the last step; the new one is in the result
  /// @param extra    of the last step, becomes that of this one; untouched unless keeps_extra_history
  template <class T>
  GYRO_HD static ContactLoad<T> load(const ContactConstants<T>& law, const ContactMotion<T>& c,
                                     const ContactHistory<T>& history, ExtraHistory<T>& extra) {
    const T approach = dot(c.velocity, c.normal);
    const NormalLoad<T> normal = Normal::load(law, c, approach, history, extra);
    const Vec3<T> slide = c.velocity - approach * c.normal;
    const FrictionLoad<T> friction = friction_load(law, c.normal, slide, normal, history);
    const RollingState<T> rolling{tangential(c.angular_velocity, c.normal), friction.force, normal};
    const RollingLoad<T> roll = Rolling::load(law, c, rolling, extra);

    ContactLoad<T> out;
    out.force = friction.force - normal.push * c.normal;
    out.couple = roll.couple;
    const Vec3<T> drag = friction.force - friction.elastic - (normal.push - normal.spring) * c.normal;
    out.history = {friction.elastic, c.overlap, drag};
    out.damped = T(-0.5) * law.dt * dot(history.drag + drag, c.velocity);
    if constexpr (Normal::has_hysteresis) out.damped = out.damped + normal.damped;
    if constexpr (Rolling::has_spring) out.damped = out.damped + roll.damped;
    out.slipped = friction.slipped + roll.slipped;
    out.dashpot = normal.dashpot;
    return out;
  }

  /// Elastic energy of a contact: of its normal, tangential and rolling springs [J].
  /// @param overlap  of the normal spring [m]: that of the history or, where a force is held, of now
  template <class T>
  GYRO_HD static T energy(const ContactConstants<T>& law, T radius, T overlap, const ContactHistory<T>& h,
                          const ExtraHistory<T>& extra) {
    const T sliding = friction_energy(Normal::tangential_stiffness(law, radius, h.overlap), h.elastic);
    const T energy = Normal::energy(law, radius, overlap, extra) + sliding;
    if constexpr (Rolling::has_spring)
      return energy + Rolling::energy(law, radius, Normal::stiffness(law, radius, h.overlap), extra);
    else
      return energy;
  }

  /// @param radius  R* [m]
  GYRO_HD static ContactStiffness stiffness(const ContactConstants<double>& law, double radius, double overlap) {
    double rolling = 0;
    if constexpr (Rolling::has_spring)
      rolling = Rolling::stiffness(law, radius, Normal::stiffness(law, radius, overlap));
    return {Normal::max_stiffness(law, radius, overlap), Normal::tangential_stiffness(law, radius, overlap), rolling,
            Normal::damping_ratio(law), Normal::margin};
  }
};

}  // namespace gyro
