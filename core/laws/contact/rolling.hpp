// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/contact.hpp"

// The laws of rolling resistance. Each gives the couple on i; j receives the opposite. A law that has_spring also gives
// the stiffness and the energy of its spring, and has a dashpot.

namespace gyro {

/// Result of a rolling law.
template <class T>
struct RollingLoad {
  Vec3<T> couple;  ///< on i [N m]
  T slipped;       ///< work lost to rolling resistance in this step [J]
  T damped;        ///< work lost to its dashpot in this step [J]
};

/// What a rolling law reads beside the constants and the kinematics.
template <class T>
struct RollingState {
  Vec3<T> roll;      ///< relative angular velocity in the tangent plane [rad/s]
  Vec3<T> friction;  ///< tangential force on i [N]
  NormalLoad<T> normal;
};

/// No rolling resistance: chosen where the coefficient is zero.
struct NoRolling {
  static constexpr bool keeps_extra_history = false, has_spring = false;

  template <class T>
  GYRO_HD static RollingLoad<T> load(const ContactConstants<T>&, const ContactMotion<T>&, const RollingState<T>&,
                                     ExtraHistory<T>&) {
    return {{T(0), T(0), T(0)}, T(0), T(0)};
  }
};

/// Constant torque against the rolling; near rest, what balances friction.
///
///   M = -(I* w/(4 dt) + l n x Ft), |M| <= mu_r R* Fn      w the relative rolling, l the lever of Ft on it
///
/// A sphere stays on a slope without creep. The torque takes a quarter of the rolling that is left in a step, so that
/// up to eight contacts of a particle together do not turn it round.
///
/// Source: type A of Ai, Chen, Rotter & Ooi, Powder Technol. 206 (2011) 269. Departure: theirs keeps its full size at
/// rest and chatters there.
struct ConstantRolling {
  static constexpr bool keeps_extra_history = false, has_spring = false;

  template <class T>
  GYRO_HD static RollingLoad<T> load(const ContactConstants<T>& law, const ContactMotion<T>& c,
                                     const RollingState<T>& s, ExtraHistory<T>&) {
    const Vec3<T> resting = (T(0.25) / law.dt * c.inertia) * s.roll + c.lever * cross(c.normal, s.friction);
    RollingLoad<T> out;
    out.couple = -share_within(norm(resting), law.rolling * c.radius * s.normal.push) * resting;
    out.slipped = -(law.dt * dot(out.couple, s.roll));
    out.damped = T(0);
    return out;
  }
};

/// Elastic-plastic spring and dashpot against the rolling.
///
///   Mk = Mk0 - kr w dt, |Mk| <= mu_r R* Fn     kr = 2.25 Sn (mu_r R*)^2, Sn the stiffness of the normal spring
///   M  = Mk - cr w                             cr = 2 eta sqrt(Ir kr), eta = 0.3; no dashpot at the limit
///   Ir = 7/2 I*                                reduced inertia about the contact point: exact for equal spheres and
///   walls
///
/// Mk0 is the elastic torque of the last step, laid into the tangent plane and scaled while unloading as friction is.
/// Loses as friction does: what goes into the spring less what it stores.
///
/// Source: type C of Ai, Chen, Rotter & Ooi, Powder Technol. 206 (2011) 269, eqs. for kr and cr in three dimensions.
/// Departure: their Ir sums 1/(I + m R^2) of both bodies, which is 7/2 I* of unequal spheres only nearly.
struct SpringDashpotRolling {
  static constexpr bool keeps_extra_history = true, has_spring = true;

  template <class T>
  GYRO_HD static RollingLoad<T> load(const ContactConstants<T>& law, const ContactMotion<T>& c,
                                     const RollingState<T>& s, ExtraHistory<T>& extra) {
    using std::sqrt;
    const T limit = law.rolling * c.radius * s.normal.push;
    const T spring = stiffness_of(law, c.radius, s.normal.stiffness);
    const T last_size2 = norm2(extra.roll_elastic);
    const Vec3<T> laid = laid_into_plane(extra.roll_elastic, last_size2, c.normal);

    const Vec3<T> trial = s.normal.unloading * laid - (spring * law.dt) * s.roll;
    const T size = norm(trial);
    const Vec3<T> elastic = share_within(size, limit) * trial;
    const T damping = select(size > limit, T(0), T(0.6) * sqrt(T(3.5) * c.inertia * spring));  // 2 eta
    const Vec3<T> drag = -damping * s.roll;

    RollingLoad<T> out;
    out.couple = elastic + drag;
    // What the spring stores now and stored before: its stiffness falls and grows as the tangential one.
    const T stored = T(0.5) / larger(spring, T(1e-30)) * (norm2(elastic) - s.normal.stiffening * last_size2);
    out.slipped = T(-0.5) * law.dt * dot(laid + elastic, s.roll) - stored;
    out.damped = T(-0.5) * law.dt * dot(extra.roll_drag + drag, s.roll);
    extra.roll_elastic = elastic;
    extra.roll_drag = drag;
    return out;
  }
  /// kr [N m/rad] for a normal spring of this stiffness: for the limit of the step.
  template <class T>
  GYRO_HD static T stiffness(const ContactConstants<T>& law, T radius, T normal_stiffness) {
    return stiffness_of(law, radius, normal_stiffness);
  }
  /// Energy of the rolling spring, Mk^2/(2 kr) [J].
  template <class T>
  GYRO_HD static T energy(const ContactConstants<T>& law, T radius, T normal_stiffness, const ExtraHistory<T>& extra) {
    return norm2(extra.roll_elastic) / larger(T(2) * stiffness_of(law, radius, normal_stiffness), T(1e-30));
  }

 private:
  template <class T>
  GYRO_HD static T stiffness_of(const ContactConstants<T>& law, T radius, T normal_stiffness) {
    const T lever = law.rolling * radius;
    return T(2.25) * normal_stiffness * lever * lever;
  }
};

}  // namespace gyro
