// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/contact.hpp"

namespace gyro {

/// Hysteretic linear normal force: stiffer on unloading than on loading, without a dashpot.
///
///   Fn = min(k1 d, max(0, k2 (d - d0)))      d0 = (1 - k1/k2) d_max, d_max the largest overlap so far
///   k2 = k1/e^2                              restitution e = sqrt(k1/k2), whatever the speed
///   k1 = 4/3 sqrt(0.1) E* R*                 St = (4 G*/E*) k1
///
/// Reloading goes up the unloading line to d_max and then along the loading line. Energy is lost by hysteresis only:
/// the spring holds Fn^2/(2 k2), the rest of its work is lost.
///
/// k1 makes the loading force equal to Hertz's at an overlap of R*/10, which is usual when rock is crushed; St/k1 is
/// Mindlin's St over Sn. Both are choices of this program: the sources leave k1 to the user.
///
/// Sources: Walton & Braun, J. Rheol. 30 (1986) 949; Luding, Granul. Matter 10 (2008) 235, without its cohesion and
/// with a constant k2.
struct Hysteretic {
  static constexpr bool keeps_extra_history = true, has_hysteresis = true;
  static constexpr double margin = 16;  ///< as ContactStiffness::margin

  /// @param c  kinematics; c.overlap > 0
  template <class T>
  GYRO_HD static NormalLoad<T> load(const ContactConstants<T>& law, const ContactMotion<T>& c, T,
                                    const ContactHistory<T>& history, ExtraHistory<T>& extra) {
    const T k1 = loading_stiffness(law, c.radius), k2 = law.unloading * k1;
    const T last = force(law, k2, history.overlap, extra.max_overlap);
    extra.max_overlap = larger(c.overlap, extra.max_overlap);
    NormalLoad<T> out;
    out.stiffness = k1;
    out.spring = out.push = force(law, k2, c.overlap, extra.max_overlap);
    out.tangential_stiffness = tangential_stiffness(law, c.radius, c.overlap);
    out.tangential_damping = out.dashpot = T(0);
    out.stiffening = out.unloading = T(1);
    const T work = T(0.5) * (last + out.push) * (c.overlap - history.overlap);
    out.damped = work - (out.push * out.push - last * last) / (k2 + k2);
    return out;
  }

  /// Stiffness of the loading spring, and the stiffness that limits the step [N/m]: 16 k2, a quarter of the step that
  /// would be stable. A step that passes from the loading to the unloading line takes its force from one of them: at
  /// 0.7 of the stable step a restitution of 0.5 is off by 10 %, at a quarter of that by 0.6 % (cases/bench/accuracy).
  template <class T>
  GYRO_HD static T stiffness(const ContactConstants<T>& law, T radius, T) {
    return loading_stiffness(law, radius);
  }
  template <class T>
  GYRO_HD static T max_stiffness(const ContactConstants<T>& law, T radius, T) {
    return T(margin) * law.unloading * loading_stiffness(law, radius);
  }
  template <class T>
  GYRO_HD static T tangential_stiffness(const ContactConstants<T>& law, T radius, T) {
    return T(4) * (law.shear / law.youngs) * loading_stiffness(law, radius);
  }

  /// There is no dashpot.
  GYRO_HD static double damping_ratio(const ContactConstants<double>&) { return 0; }

  /// Energy that the spring gives back, Fn^2/(2 k2) [J].
  template <class T>
  GYRO_HD static T energy(const ContactConstants<T>& law, T radius, T overlap, const ExtraHistory<T>& extra) {
    const T k2 = law.unloading * loading_stiffness(law, radius);
    const T push = force(law, k2, overlap, larger(overlap, extra.max_overlap));
    return push * push / (k2 + k2);
  }

  /// k1 [N/m].
  template <class T>
  GYRO_HD static T loading_stiffness(const ContactConstants<T>& law, T radius) {
    return T(0.42163702135578390) * law.youngs * radius;  // 4/3 sqrt(0.1)
  }

 private:
  /// On the unloading line of max_overlap >= overlap, whose end is on the loading line.
  template <class T>
  GYRO_HD static T force(const ContactConstants<T>& law, T k2, T overlap, T max_overlap) {
    return positive(k2 * (overlap - (T(1) - T(1) / law.unloading) * max_overlap));
  }
};

}  // namespace gyro
