// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond_springs.hpp"
#include "core/laws/bond_strain.hpp"
#include "core/math/select.hpp"

namespace gyro {

/// Constants of all bonds of a scene.
template <class T>
struct BondLaw {
  T normal_stiffness;  ///< part of k_n that is the same for all bonds, per area [Pa/m]
  T shear_stiffness;   ///< part of k_s that is the same for all bonds, per area [Pa/m]
  T normal_modulus;    ///< part of k_n that falls with the length, k_n L0 [Pa]
  T shear_modulus;     ///< part of k_s that falls with the length, k_s L0 [Pa]
  T tensile_strength;  ///< sigma_c [Pa]
  T shear_strength;    ///< tau_c [Pa]
  T damping;           ///< xi, fraction of critical of each mode of the bond [-]
  T friction;          ///< mu, after failure [-]
  T dt;                ///< time step: velocities are dt/2 older than positions [s]
};

/// The same constants in another number type, or one copy for each lane of a pack.
template <class To, class From>
GYRO_HD BondLaw<To> cast(const BondLaw<From>& law) {
  return {.normal_stiffness = static_cast<To>(law.normal_stiffness),
          .shear_stiffness = static_cast<To>(law.shear_stiffness),
          .normal_modulus = static_cast<To>(law.normal_modulus),
          .shear_modulus = static_cast<To>(law.shear_modulus),
          .tensile_strength = static_cast<To>(law.tensile_strength),
          .shear_strength = static_cast<To>(law.shear_strength),
          .damping = static_cast<To>(law.damping),
          .friction = static_cast<To>(law.friction),
          .dt = static_cast<To>(law.dt)};
}

/// Section and strength of one bond.
template <class T>
struct BondSection {
  T radius;        ///< Rb of the circular section [m]
  T strength;      ///< factor on both strengths [-]
  T sqrt_mass;     ///< sqrt(m_i m_j / (m_i + m_j)) [kg^1/2]
  T sqrt_inertia;  ///< sqrt(I_i I_j / (I_i + I_j)) [kg^1/2 m]
  T arm;           ///< a_i, as in BondShape [-]
  T length;        ///< L0 [m]
};

/// Velocities of the two ends of a bond, half a step before their places. World frame.
template <class T>
struct BondRates {
  Vec3<T> velocity;  ///< v_j - v_i [m/s]
  Vec3<T> angular_velocity_i, angular_velocity_j;
};

/// Loads of a bond and what the ledger needs.
template <class T>
struct BondLoad {
  Vec3<T> force;     ///< on j; i receives the opposite [N]
  Vec3<T> torque_i;  ///< on i [N m]
  Vec3<T> torque_j;  ///< on j [N m]
  T tension_ratio;   ///< tensile stress / strength [-]
  T shear_ratio;     ///< shear stress / strength [-]
  T elastic;         ///< stored energy [J]
  T damped;          ///< work lost to damping in this step: of its loads on the ends' velocities [J]
};

namespace bond_detail {

/// Moments of a force F on j (and -F on i) that acts at the section x_i + a_i d, plus a couple on j
/// (and its opposite on i): angular momentum is kept exactly.
template <class T>
GYRO_HD void set_torques(BondLoad<T>& out, T arm, const Vec3<T>& span, const Vec3<T>& couple) {
  const Vec3<T> lever = cross(span, out.force);
  out.torque_i = -(arm * lever) - couple;
  out.torque_j = couple - (T(1) - arm) * lever;
}

template <class T>
GYRO_HD T normal_stiffness(const BondLaw<T>& law, const BondSection<T>& b) {
  return stiffness_per_area(law.normal_stiffness, law.normal_modulus, b.length);
}
template <class T>
GYRO_HD T shear_stiffness(const BondLaw<T>& law, const BondSection<T>& b) {
  return stiffness_per_area(law.shear_stiffness, law.shear_modulus, b.length);
}

/// Velocity of j's side of the section relative to i's side [m/s], for a span that the two ends carry.
template <class T>
GYRO_HD Vec3<T> slide_velocity(const BondRates<T>& r, T arm, const Vec3<T>& span) {
  return r.velocity - cross(arm * r.angular_velocity_i + (T(1) - arm) * r.angular_velocity_j, span);
}

/// The span half a step ago, when velocities were what they are: with the present one a bond that turns as a rigid body
/// would be damped. Work goes with the present span, about which the moments are taken.
template <class T>
GYRO_HD Vec3<T> span_of_rates(const BondLaw<T>& law, const BondRates<T>& r, const Vec3<T>& span) {
  return span - (T(0.5) * law.dt) * r.velocity;
}

/// Elastic loads of an intact bond: a force on j that acts at the section, and a couple on j.
template <class T>
struct ElasticLoads {
  Vec3<T> force, couple;
};

/// Minus the gradient of U, see bond_load(). Turns of the ends by small f_i, f_j change
///
///   theta by w (f_j - f_i) + 1/2 (f_i + f_j) x theta           w = sqrt(1 - |theta|^2/4)
///   e_w   by (f + kappa/2 (f_j - f_i) x theta) x e_w           kappa = a_i a_j / N, N = 1 - 2 a_i a_j (1 - w)
///
/// where f = (a_i f_i + a_j f_j) + 2 kappa (1 - w) (1/2 - a_i) (f_j - f_i). Terms beyond the first power of the strains
/// are what keeps the energy: without them a crushed rock of soft bonds lost 2e-4 of its work at any step.
template <class T>
GYRO_HD ElasticLoads<T> elastic_loads(const BondSprings<T>& k, T length0, T arm, const BondStrain<T>& s) {
  using std::sqrt;
  const T ratio = length0 / s.length;
  const Vec3<T> shear = (k.shear * length0 * ratio * s.along) * s.shear;
  const Vec3<T> tilt = ((k.bending - k.twist) * s.twist / s.length) * s.bend;  // n turns in a twisted and bent bond

  const Vec3<T> theta = s.bend + s.twist * s.normal;
  const T w = sqrt(positive(T(1) - T(0.25) * norm2(theta))), missing = T(1) - w;
  const T both = arm * (T(1) - arm), kappa = both / (T(1) - (both + both) * missing);
  const Vec3<T> span = s.length * s.normal, lever = cross(span, shear);
  const Vec3<T> uneven = cross(span, tilt) - ((kappa + kappa) * missing) * lever;
  return {shear + tilt - (k.normal * s.stretch) * s.normal,
          (T(0.5) - arm) * uneven - (T(0.5) * kappa) * cross(theta, lever) - (w * k.twist * s.twist) * s.normal -
              (w * k.bending) * s.bend};
}

}  // namespace bond_detail

/// Bond between two particles: the parallel bond of Potyondy & Cundall, "A bonded-particle model
/// for rock", Int. J. Rock Mech. Min. Sci. 41 (2004) 1329, in total form.
///
///   kn    = normal_stiffness + normal_modulus/L0              ks likewise
///   U     = 1/2 kn A (L - L0)^2 + 1/2 ks A L0^2 |gamma|^2 + 1/2 ks J theta_n^2 + 1/2 kn I |theta_s|^2
///   F_j   = -kn A (L - L0) n + ks A L0^2 (c/L) gamma          A = pi Rb^2
///   M_j   = -ks J theta_n n - kn I theta_s                    I = pi Rb^4/4, J = pi Rb^4/2
///   sigma = kn (L - L0) + kn Rb |theta_s|        >= sigma_c   tension with bending, or
///   tau   = ks L0 (L0/L) c |gamma| + ks Rb |theta_n| >= tau_c shear with twist
///
/// F_j and M_j to the first power of the strains: elastic_loads() has the gradient of U itself, so that strained bonds
/// give back what they took. Damping 2 xi sqrt(k m*) on the rate of each mode counts neither for the stresses nor
/// for U. Compression lowers sigma. Departure from Xiong et al. (Minerals 2024, eqs. 3-8), who print
/// Rb^2 in I and J and the minimum of two stresses: misprints.
template <class T>
GYRO_HD BondLoad<T> bond_load(const BondLaw<T>& law, const BondSection<T>& b, const BondStrain<T>& s,
                              const BondRates<T>& rates) {
  using std::sqrt;
  const T kn = bond_detail::normal_stiffness(law, b), ks = bond_detail::shear_stiffness(law, b);
  const BondSprings<T> k = bond_springs(kn, ks, b.radius);
  const bond_detail::ElasticLoads<T> elastic = bond_detail::elastic_loads(k, b.length, b.arm, s);

  const Vec3<T> span = s.length * s.normal;
  const Vec3<T> slide = bond_detail::slide_velocity(rates, b.arm, bond_detail::span_of_rates(law, rates, span));
  const T slide_n = dot(slide, s.normal);
  const Vec3<T> slide_s = slide - slide_n * s.normal;
  const Vec3<T> roll = rates.angular_velocity_j - rates.angular_velocity_i;
  const T roll_n = dot(roll, s.normal);
  const Vec3<T> roll_s = roll - roll_n * s.normal;

  // 2 xi sqrt(k m*) of the four springs: kn I = kn A Rb^2/4 and ks J = ks A Rb^2/2.
  const T root_n = (law.damping + law.damping) * sqrt(k.normal);
  const T root_s = (law.damping + law.damping) * sqrt(k.shear);
  const T half_arm = T(0.5) * b.radius * b.sqrt_inertia;
  const T c_n = root_n * b.sqrt_mass, c_s = root_s * b.sqrt_mass;
  const T c_b = root_n * half_arm, c_t = root_s * half_arm * T(1.4142135623730951);

  BondLoad<T> out;
  const Vec3<T> drag = (c_n * slide_n) * s.normal + c_s * slide_s;
  out.force = elastic.force - drag;
  bond_detail::set_torques(out, b.arm, span, elastic.couple - (c_t * roll_n) * s.normal - c_b * roll_s);
  out.damped = law.dt * (dot(drag, bond_detail::slide_velocity(rates, b.arm, span)) + c_t * roll_n * roll_n +
                         c_b * norm2(roll_s));

  const T shear2 = norm2(s.shear), bend2 = norm2(s.bend);
  const T tension = kn * s.stretch, shear_rate = ks * b.length * (b.length / s.length) * s.along;
  out.tension_ratio = (tension + kn * b.radius * sqrt(bend2)) / (law.tensile_strength * b.strength);
  out.shear_ratio =
      (shear_rate * sqrt(shear2) + ks * b.radius * magnitude(s.twist)) / (law.shear_strength * b.strength);
  out.elastic = T(0.5) * (k.normal * s.stretch * s.stretch + k.shear * b.length * b.length * shear2 +
                          k.twist * s.twist * s.twist + k.bending * bend2);
  return out;
}

/// Power of a bond's loads on its two ends [W].
template <class T>
GYRO_HD T bond_power(const BondLoad<T>& load, const BondRates<T>& rates) {
  return dot(load.force, rates.velocity) + dot(load.torque_i, rates.angular_velocity_i) +
         dot(load.torque_j, rates.angular_velocity_j);
}

/// Loads of a pressed bond, and how much of its shear survived the friction limit.
template <class T>
struct PressedLoad {
  BondLoad<T> load;
  T keep;       ///< share of the shear strain that is left after slip; 1: no slip [-]
  T slip_work;  ///< lost to friction in this step [J]
};

/// A bond that has failed and whose ends have not come apart yet: a spring that only pushes. Its
/// compressive force is that of the intact bond, so failure adds no force and no stiffness.
///
///   F_n = max(0, -kn A (L - L0) - c_n v_n) while L < L0
///   F_s = ks A L0^2 (c/L) gamma, cut to mu F_n; the cut share of gamma is slip (slipped_axis)
template <class T>
GYRO_HD PressedLoad<T> pressed_load(const BondLaw<T>& law, const BondSection<T>& b, const BondStrain<T>& s,
                                    const BondRates<T>& rates) {
  using std::sqrt;
  const T kn = bond_detail::normal_stiffness(law, b), ks = bond_detail::shear_stiffness(law, b);
  const BondSprings<T> k = bond_springs(kn, ks, b.radius);
  const Vec3<T> span = s.length * s.normal;

  const Vec3<T> slide = bond_detail::slide_velocity(rates, b.arm, span);
  const T slide_n = dot(slide, s.normal);
  const Vec3<T> span_then = bond_detail::span_of_rates(law, rates, span);
  const T part_n = dot(bond_detail::slide_velocity(rates, b.arm, span_then), s.normal);
  const T c_n = (law.damping + law.damping) * sqrt(k.normal) * b.sqrt_mass;
  const T spring = positive(-(k.normal * s.stretch));
  const T push = select(s.stretch < T(0), positive(spring - c_n * part_n), T(0));

  const T gamma2 = norm2(s.shear);
  const T stiff = k.shear * b.length * (b.length / s.length) * s.along;
  const T trial = magnitude(stiff) * sqrt(gamma2), limit = law.friction * push;
  const T spring_s = larger(magnitude(stiff) / s.length, T(1e-30));  // shear force over slide, now [N/m]

  PressedLoad<T> out;
  out.keep = select(trial > limit, limit / larger(trial, T(1e-30)), T(1));
  out.load.force = push * s.normal + (out.keep * stiff) * s.shear;
  bond_detail::set_torques(out.load, b.arm, span, T(0) * s.normal);
  out.load.tension_ratio = out.load.shear_ratio = T(0);

  const T kept = out.keep * stiff;
  out.load.elastic = T(0.5) * spring * magnitude(s.stretch) + kept * kept * gamma2 / (spring_s + spring_s);
  out.load.damped = select(s.stretch < T(0), law.dt * (spring - push) * slide_n, T(0));

  // Friction loses what goes into the shear spring less what it stores more. The spring is that of the
  // present length: ends that were packed with an overlap slide past each other at L > L0.
  const Vec3<T> slide_s = slide - slide_n * s.normal;
  const Vec3<T> after = kept * s.shear, before = stiff * s.shear + (spring_s * law.dt) * slide_s;
  const T lost =
      T(-0.5) * law.dt * dot(before + after, slide_s) + (norm2(before) - norm2(after)) / (spring_s + spring_s);
  out.slip_work = select(out.keep < T(1), lost, T(0));
  return out;
}

}  // namespace gyro
