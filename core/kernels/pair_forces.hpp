// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/contact.hpp"
#include "core/state/bonds.hpp"
#include "core/state/contacts.hpp"
#include "core/state/particles.hpp"

namespace gyro {

/// Contact of two particles: force into the pair's own slot.
/// @tparam Law   a ContactLaw
/// @tparam held  forces are held over several sub-steps
template <class Real, class Law, bool held>
struct PairForces {
  ConstParticleView p;
  PairView<Real> pairs;
  const std::int32_t* bond_state;  ///< null without bonds
  ContactConstants<Real> constants;
  double half_hold_offset;  ///< as in contact_position() [s]
  OverlapCheck deep;

  GYRO_HD void operator()(Index n) const {
    const Pair pair = pairs.pair[n];
    const Sphere a = contact_position<held>(p, pair.i, half_hold_offset),
                 b = contact_position<held>(p, pair.j, half_hold_offset);
    const Vec3d span = b.x - a.x;
    const double sum = a.radius + b.radius, distance2 = norm2(span);
    const bool bonded = pair.bond != none && bond_state[pair.bond] != bond_broken;
    const double distance = distance2 < sum * sum ? ::sqrt(distance2) : sum;
    if (!(distance < sum) || bonded) {  // NaN pairs are treated as not touching; the guard reports them
      if (pairs.touching[n]) {
        pairs.touching[n] = 0;
        pairs.history[n] = {};
        if constexpr (Law::keeps_extra_history) pairs.extra[n] = {};
      }
      return;
    }
    pairs.touching[n] = 1;
    evaluate(n, pair, a, b, span, distance);
  }

 private:
  GYRO_HD void evaluate(Index n, const Pair& pair, const Sphere& a, const Sphere& b, const Vec3d& span,
                        double distance) const {
    const Motion va = p.motion[pair.i], vb = p.motion[pair.j];
    const AngularMotion wa = p.angular_motion[pair.i], wb = p.angular_motion[pair.j];
    const double overlap = a.radius + b.radius - distance;
    deep.check_overlap(overlap, smaller(a.radius, b.radius));
    const double arm_a = a.radius - 0.5 * overlap, arm_b = b.radius - 0.5 * overlap;
    const Vec3d normal = (1 / distance) * span;

    ContactMotion<Real> c;
    c.normal = cast<Real>(normal);
    c.overlap = static_cast<Real>(overlap);
    c.velocity = cast<Real>(va.v - vb.v + cross(arm_a * wa.w + arm_b * wb.w, normal));
    c.angular_velocity = cast<Real>(wa.w - wb.w);
    c.radius = static_cast<Real>(a.radius * b.radius / (a.radius + b.radius));
    c.mass = static_cast<Real>(va.mass * vb.mass / (va.mass + vb.mass));
    const double inertias = wa.inertia + wb.inertia;
    c.inertia = static_cast<Real>(wa.inertia * wb.inertia / inertias);
    c.lever = static_cast<Real>((arm_a * wb.inertia - arm_b * wa.inertia) / inertias);

    ExtraHistory<Real> extra{};
    if constexpr (Law::keeps_extra_history) extra = pairs.extra[n];
    const ContactLoad<Real> load = Law::load(constants, c, pairs.history[n], extra);
    if constexpr (Law::keeps_extra_history) pairs.extra[n] = extra;

    const Vec3<Real> lever = cross(c.normal, load.force);
    pairs.history[n] = load.history;
    pairs.result[n] = {load.force, static_cast<Real>(arm_a) * lever + load.couple,
                       static_cast<Real>(arm_b) * lever - load.couple, load.damped, load.slipped};
  }
};

}  // namespace gyro
