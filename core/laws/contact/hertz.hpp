// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/dashpots.hpp"

namespace gyro {

/// Hertz's normal force with a dashpot, and the stiffness of Mindlin's tangential spring.
///
///   Fn = max(0, 4/3 E* sqrt(R* d) d + c(Sn) vn)        Sn = 2 E* sqrt(R* d), vn > 0 approaching
///   c(S) = 2 sqrt(5/6) zeta sqrt(S m*)                 St = 8 G* sqrt(R* d)
///
/// The force cannot pull. The dashpot's form makes the restitution independent of the speed; the constant zeta
/// belongs to a force that cannot pull (restitution.hpp). Both dashpots are capped (dashpots.hpp).
///
/// Sources: Johnson, Contact Mechanics (1985), ch. 4 and 7; Tsuji, Tanaka & Ishida, Powder Technol. 71 (1992) 239
/// for the form of the damping.
struct Hertz {
  static constexpr bool keeps_extra_history = false, has_hysteresis = false;
  static constexpr double margin = 1;  ///< as ContactStiffness::margin

  /// @param c  kinematics; c.overlap > 0
  template <class T>
  GYRO_HD static NormalLoad<T> load(const ContactConstants<T>& law, const ContactMotion<T>& c, T approach,
                                    const ContactHistory<T>& history, ExtraHistory<T>&) {
    using std::sqrt;
    const T root = sqrt(c.radius * c.overlap), last_root = sqrt(c.radius * history.overlap);
    NormalLoad<T> out;
    out.stiffness = T(2) * law.youngs * root;
    out.tangential_stiffness = T(8) * law.shear * root;
    out.stiffening = root / larger(last_root, T(1e-30));
    out.unloading = smaller(out.stiffening, T(1));
    out.spring = T(2.0 / 3.0) * out.stiffness * c.overlap;
    // c(S) = damp sqrt(S/root) sqrt(root m*), where S/root is a constant; q = max(c_n, 3.5 c_t).
    const T damp = T(1.8257418583505538) * law.damping;  // 2 sqrt(5/6) zeta
    const T heavier = damp * larger(law.youngs_root, T(spin_share) * law.shear_root);
    const T mass_root = sqrt(root * c.mass);
    out.dashpot = heavier * mass_root;
    const T cap = largest_dashpot(law, c, out.dashpot, heavier * sqrt(last_root * c.mass));
    out.push = positive(out.spring + smaller(damp * law.youngs_root * mass_root, cap) * approach);
    out.tangential_damping = smaller(damp * law.shear_root * mass_root, T(1 / spin_share) * cap);
    out.damped = T(0);
    return out;
  }

  /// Stiffness of the normal spring at an overlap, and the largest that it can have there [N/m].
  template <class T>
  GYRO_HD static T stiffness(const ContactConstants<T>& law, T radius, T overlap) {
    using std::sqrt;
    return T(2) * law.youngs * sqrt(radius * overlap);
  }
  template <class T>
  GYRO_HD static T max_stiffness(const ContactConstants<T>& law, T radius, T overlap) {
    return stiffness(law, radius, overlap);
  }
  template <class T>
  GYRO_HD static T tangential_stiffness(const ContactConstants<T>& law, T radius, T overlap) {
    using std::sqrt;
    return T(8) * law.shear * sqrt(radius * overlap);
  }

  /// c(S)/(2 sqrt(S m*)), the same for both dashpots [-].
  GYRO_HD static double damping_ratio(const ContactConstants<double>& law) { return ::sqrt(5.0 / 6) * law.damping; }

  /// Energy of the normal spring, 2/5 of (4/3 E* sqrt(R* d) d) d [J].
  template <class T>
  GYRO_HD static T energy(const ContactConstants<T>& law, T radius, T overlap, const ExtraHistory<T>&) {
    using std::sqrt;
    return T(8.0 / 15.0) * law.youngs * sqrt(radius * overlap) * overlap * overlap;
  }
};

}  // namespace gyro
