// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/bond.hpp"
#include "core/laws/bond/springs.hpp"

// The section of a bond, at x_i + a_i d: its stiffness, its motion, and the torques of a force that acts there.

namespace gyro::bond_detail {

/// k_n and k_s of one bond [Pa/m].
template <class T>
GYRO_HD T normal_stiffness(const BondConstants<T>& law, const BondSection<T>& b) {
  return stiffness_per_area(law.bond.normal_stiffness, law.bond.normal_modulus, b.length);
}
template <class T>
GYRO_HD T shear_stiffness(const BondConstants<T>& law, const BondSection<T>& b) {
  return stiffness_per_area(law.bond.shear_stiffness, law.bond.shear_modulus, b.length);
}

template <class T>
GYRO_HD BondSprings<T> springs_of(const BondConstants<T>& law, const BondSection<T>& b) {
  return bond_springs(normal_stiffness(law, b), shear_stiffness(law, b), b.radius);
}

/// Velocity of j's side of the section relative to i's side, when each side moves with its end as a rigid body [m/s].
/// @param span  x_j - x_i [m]
template <class T>
GYRO_HD Vec3<T> section_velocity(const BondRates<T>& r, T arm, const Vec3<T>& span) {
  return r.velocity - cross(arm * r.angular_velocity_i + (T(1) - arm) * r.angular_velocity_j, span);
}

/// The span half a step ago, at the time of the velocities [m]. With the present span, a bond that rotates as a rigid
/// body would be damped. Work is computed with the present span, because the torques are.
template <class T>
GYRO_HD Vec3<T> span_of_rates(const BondConstants<T>& law, const BondRates<T>& r, const Vec3<T>& span) {
  return span - (T(0.5) * law.dt) * r.velocity;
}

/// Torques of the force out.force on j (and its opposite on i) that acts at the section, plus a couple on j (and its
/// opposite on i). Angular momentum is conserved to rounding.
/// @param span    x_j - x_i [m]
/// @param couple  [N m]
template <class T>
GYRO_HD void set_torques(BondLoad<T>& out, T arm, const Vec3<T>& span, const Vec3<T>& couple) {
  const Vec3<T> lever = cross(span, out.force);
  out.torque_i = -(arm * lever) - couple;
  out.torque_j = couple - (T(1) - arm) * lever;
}

}  // namespace gyro::bond_detail
