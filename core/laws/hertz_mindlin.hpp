// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/math/select.hpp"
#include "core/math/vec3.hpp"

namespace gyro {

/// Constants of one pair of materials, combined once.
template <class T>
struct ContactLaw {
  T youngs;    ///< E* [Pa], 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
  T shear;     ///< G* [Pa], 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2
  T damping;   ///< zeta >= 0 [-], from the restitution: damping_for_restitution()
  T friction;  ///< Coulomb coefficient mu [-]
  T rolling;   ///< rolling friction mu_r [-]
  T dt;        ///< time step [s]
};

/// Kinematics of one contact, seen from body i. World frame.
template <class T>
struct ContactMotion {
  Vec3<T> normal;            ///< unit vector from i to j
  T overlap;                 ///< delta > 0 while the bodies touch [m]
  Vec3<T> velocity;          ///< of i relative to j at the contact point [m/s]
  Vec3<T> angular_velocity;  ///< of i relative to j [rad/s]
  T radius;                  ///< R* = Ri Rj/(Ri + Rj) [m]
  T mass;                    ///< m* = mi mj/(mi + mj) [kg]
  T inertia;                 ///< I* = Ii Ij/(Ii + Ij) [kg m2]
  T lever;                   ///< I* (ai/Ii - aj/Ij), a the arms: of friction on the relative spin [m]
};

/// What a contact remembers of the last step. Zero for a new contact.
template <class T>
struct ContactHistory {
  Vec3<T> elastic;  ///< elastic tangential force on i [N]
  T overlap;        ///< [m]
  Vec3<T> drag;     ///< damping force on i, normal and tangential: for the ledger alone [N]

  template <class F, class... H>
  static constexpr void for_each_field(F&& f, H&... h) {
    f("elastic", h.elastic...);
    f("overlap", h.overlap...);
    f("drag", h.drag...);
  }
};
static_assert(declares_every_field<ContactHistory<float>>);

/// Loads on body i, what the contact remembers, and what the ledger needs.
template <class T>
struct ContactLoad {
  Vec3<T> force;              ///< on i [N]
  Vec3<T> couple;             ///< rolling resistance on i; j receives the opposite [N m]
  ContactHistory<T> history;  ///< for the next step
  T damped;                   ///< work lost to damping in this step [J]
  T slipped;                  ///< work lost to friction and rolling in this step [J]
};

/// Elastic energy of a contact: 2/5 of (4/3 E* sqrt(R*) delta^1.5) delta, plus Ft^2/(2 St) [J].
template <class T>
GYRO_HD T contact_energy(const ContactLaw<T>& law, T radius, T overlap, const Vec3<T>& elastic) {
  using std::sqrt;
  const T root = sqrt(radius * overlap);
  const T stiff_t = T(8) * law.shear * root;
  return T(8.0 / 15.0) * law.youngs * root * overlap * overlap + norm2(elastic) / larger(stiff_t + stiff_t, T(1e-30));
}

/// Hertz–Mindlin contact with damping, Coulomb friction and rolling resistance.
///
///   Fn = max(0, 4/3 E* sqrt(R* d) d + c(Sn) vn)        Sn = 2 E* sqrt(R* d), vn > 0 approaching
///   Ft = Ft0 - St vt dt - c(St) vt, |Ft| <= mu Fn      St = 8 G* sqrt(R* d)
///   c(S) = 2 sqrt(5/6) zeta sqrt(S m*)
///   M  = -(I* w/(4 dt) + l n x Ft), |M| <= mu_r R* Fn   w the relative rolling, l the lever of Ft on it
///
/// Work is force times way with the mean of the forces at both ends of the step, as velocity Verlet
/// spends them; the damping force at the end alone would err by the first power of the step.
///
/// Ft0 is the elastic tangential force of the last step, laid into the present tangent plane at
/// equal size and, while unloading, scaled by St/St_old: otherwise a loop load–shear–unload would
/// create energy (Thornton & Randall 1988; `rescale` variants of later codes). While sliding there
/// is no tangential damping: the sum is cut to mu Fn.
///
/// M is a constant torque against the rolling, and near rest what balances friction, so that a sphere
/// stays on a slope without creep. It takes a quarter of the rolling that is left in a step: up to
/// eight contacts of a particle together do not turn it round.
///
/// Sources: Johnson, Contact Mechanics (1985), ch. 4 and 7; Tsuji, Tanaka & Ishida, Powder Technol.
/// 71 (1992) 239 for the form of the damping; the constant zeta belongs to a force that cannot pull.
///
/// @param c     kinematics; c.overlap > 0
/// @param past  of the last step
template <class T>
GYRO_HD ContactLoad<T> hertz_mindlin(const ContactLaw<T>& law, const ContactMotion<T>& c,
                                     const ContactHistory<T>& history) {
  using std::sqrt;
  const T tiny = T(1e-30);
  const T root = sqrt(c.radius * c.overlap);
  const T stiff_n = T(2) * law.youngs * root, stiff_t = T(8) * law.shear * root;
  const T damp = T(1.8257418583505538) * law.damping;  // 2 sqrt(5/6) zeta

  const T speed_n = dot(c.velocity, c.normal);
  const T spring_n = T(2.0 / 3.0) * stiff_n * c.overlap;
  const T push = positive(spring_n + damp * sqrt(stiff_n * c.mass) * speed_n);
  const T limit = law.friction * push;

  // The memory in the present tangent plane, at equal size, softened while unloading.
  const Vec3<T> flat = tangential(history.elastic, c.normal);
  const T size_before = norm(history.elastic), size_flat = norm(flat);
  const T unload = select(c.overlap < history.overlap, sqrt(c.overlap / larger(history.overlap, tiny)), T(1));
  const Vec3<T> laid = (size_before / larger(size_flat, tiny)) * flat;

  const Vec3<T> slide = c.velocity - speed_n * c.normal;
  const Vec3<T> trial = unload * laid - (stiff_t * law.dt) * slide;
  const T size = norm(trial);
  const T keep = select(size > limit, limit / larger(size, tiny), T(1));

  ContactLoad<T> out;
  const Vec3<T> elastic = keep * trial;
  const T damp_t = select(size > limit, T(0), damp * sqrt(stiff_t * c.mass));
  const Vec3<T> wanted = elastic - damp_t * slide;
  const T wanted_size = norm(wanted);
  const T cut = select(wanted_size > limit, limit / larger(wanted_size, tiny), T(1));
  const Vec3<T> friction = cut * wanted;
  out.force = friction - push * c.normal;
  const Vec3<T> drag = friction - elastic - (push - spring_n) * c.normal;
  out.history = {elastic, c.overlap, drag};
  out.damped = T(-0.5) * law.dt * dot(history.drag + drag, c.velocity);

  // Work into the tangential spring less what it stores is friction.
  const T root_before = sqrt(c.radius * history.overlap);
  const T stored_before = size_before * size_before / larger(T(16) * law.shear * root_before, tiny);
  const T stored = norm2(elastic) / larger(stiff_t + stiff_t, tiny);
  out.slipped = T(-0.5) * law.dt * dot(laid + elastic, slide) - (stored - stored_before);

  // Rolling.
  const Vec3<T> roll = tangential(c.angular_velocity, c.normal);
  const Vec3<T> resting = (T(0.25) * c.inertia / law.dt) * roll + c.lever * cross(c.normal, friction);
  const T needed = norm(resting), strongest = law.rolling * c.radius * push;
  const T share = select(needed > strongest, strongest / larger(needed, tiny), T(1));
  out.couple = -share * resting;
  out.slipped = out.slipped - law.dt * dot(out.couple, roll);
  return out;
}

}  // namespace gyro
