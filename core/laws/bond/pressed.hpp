// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/section.hpp"
#include "core/laws/bond/strain.hpp"

namespace gyro {

/// Loads of a pressed bond, and how much of its shear strain the friction limit has left.
template <class T>
struct PressedLoad {
  BondLoad<T> load;
  T keep;       ///< share of the shear strain that is left after slip; 1: no slip [-]
  T slip_work;  ///< lost to friction in this step [J]
};

/// A bond that has failed while its ends are still pressed together: a spring that can only push. Its compressive force
/// is that of the intact bond, so that failure adds neither force nor stiffness.
///
///   F_n = max(0, -kn A (L - L0) - c_n v_n) while L < L0
///   F_s = ks A L0^2 (c/L) gamma, |F_s| <= mu F_n        the excess of gamma is slip: slipped_axis(keep)
///
/// A choice of this program: Potyondy & Cundall (2004) replace a failed bond by an ordinary contact.
///
/// @param s      strains about pressed_axis(), world frame
/// @param rates  half a step ago, world frame
template <class T>
GYRO_HD PressedLoad<T> pressed_load(const BondConstants<T>& law, const BondSection<T>& b, const BondStrain<T>& s,
                                    const BondRates<T>& rates) {
  using std::sqrt;
  const BondSprings<T> k = bond_detail::springs_of(law, b);
  const Vec3<T> span = s.length * s.normal;

  const Vec3<T> slide = bond_detail::section_velocity(rates, b.arm, span);
  const T slide_n = dot(slide, s.normal);
  const Vec3<T> span_then = bond_detail::span_of_rates(law, rates, span);
  const T part_n = dot(bond_detail::section_velocity(rates, b.arm, span_then), s.normal);
  const T c_n = (law.bond.damping + law.bond.damping) * sqrt(k.normal) * b.sqrt_mass;
  const T spring = positive(-(k.normal * s.stretch));
  const T push = select(s.stretch < T(0), positive(spring - c_n * part_n), T(0));

  const T gamma2 = norm2(s.shear);
  const T stiff = k.shear * b.length * (b.length / s.length) * s.along;
  const T trial = magnitude(stiff) * sqrt(gamma2), limit = law.friction * push;
  const T spring_s = larger(magnitude(stiff) / s.length, T(1e-30));  // shear force / displacement, now [N/m]

  PressedLoad<T> out;
  out.keep = select(trial > limit, limit / larger(trial, T(1e-30)), T(1));
  out.load.force = push * s.normal + (out.keep * stiff) * s.shear;
  bond_detail::set_torques(out.load, b.arm, span, T(0) * s.normal);
  out.load.tension_ratio = out.load.shear_ratio = T(0);

  const T kept = out.keep * stiff;
  out.load.elastic = T(0.5) * spring * magnitude(s.stretch) + kept * kept * gamma2 / (spring_s + spring_s);
  out.load.damped = select(s.stretch < T(0), law.dt * (spring - push) * slide_n, T(0));

  // Friction loses the work on the shear spring less the growth of its energy. The spring is that of the present
  // length: ends that were packed with an overlap slide past each other at L > L0.
  const Vec3<T> slide_s = slide - slide_n * s.normal;
  const Vec3<T> after = kept * s.shear, before = stiff * s.shear + (spring_s * law.dt) * slide_s;
  const T lost =
      T(-0.5) * law.dt * dot(before + after, slide_s) + (norm2(before) - norm2(after)) / (spring_s + spring_s);
  out.slip_work = select(out.keep < T(1), lost, T(0));
  return out;
}

}  // namespace gyro
