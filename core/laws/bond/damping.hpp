// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/section.hpp"
#include "core/laws/bond/strain.hpp"

namespace gyro {

/// Loads of the dashpots of an intact bond. They act on j against the motion; i receives the opposite. World frame.
template <class T>
struct BondDrag {
  Vec3<T> force;           ///< acts at the section [N]
  Vec3<T> twist, bending;  ///< torques [N m]
  T work;                  ///< lost in this step [J]
};

/// One dashpot beside each of the four springs.
///
///   force = c_n v_n n + c_s v_s        v the velocity of j's side of the section relative to i's side
///   twist = c_t w_n n                  w = w_j - w_i
///   bending = c_b w_s                  c = 2 xi sqrt(k m*)
///
/// m* is the reduced mass of the ends for stretch and shear, their reduced moment of inertia for twist and bending.
/// @param s      strains of now, world frame
/// @param rates  half a step ago, world frame
template <class T>
GYRO_HD BondDrag<T> bond_drag(const BondConstants<T>& law, const BondSection<T>& b, const BondStrain<T>& s,
                              const BondRates<T>& rates) {
  using std::sqrt;
  const BondSprings<T> k = bond_detail::springs_of(law, b);
  const Vec3<T> n = s.normal, span = s.length * n;
  const Vec3<T> slide = bond_detail::section_velocity(rates, b.arm, bond_detail::span_of_rates(law, rates, span));
  const T slide_n = dot(slide, n);
  const Vec3<T> slide_s = slide - slide_n * n;
  const Vec3<T> rotation = rates.angular_velocity_j - rates.angular_velocity_i;
  const T rotation_n = dot(rotation, n);
  const Vec3<T> rotation_s = rotation - rotation_n * n;

  // kn I = kn A Rb^2/4 and ks J = ks A Rb^2/2.
  const T root_n = (law.bond.damping + law.bond.damping) * sqrt(k.normal);
  const T root_s = (law.bond.damping + law.bond.damping) * sqrt(k.shear);
  const T half_arm = T(0.5) * b.radius * b.sqrt_inertia;
  const T c_n = root_n * b.sqrt_mass, c_s = root_s * b.sqrt_mass;
  const T c_b = root_n * half_arm, c_t = root_s * half_arm * T(1.4142135623730951);

  BondDrag<T> out;
  out.force = (c_n * slide_n) * n + c_s * slide_s;
  out.twist = (c_t * rotation_n) * n;
  out.bending = c_b * rotation_s;
  out.work = law.dt * (dot(out.force, bond_detail::section_velocity(rates, b.arm, span)) +
                       c_t * rotation_n * rotation_n + c_b * norm2(rotation_s));
  return out;
}

}  // namespace gyro
