// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/laws/contact/constants.hpp"
#include "core/math/select.hpp"
#include "core/math/vec3.hpp"

// What every contact law reads and returns. All laws work on single numbers and on packs.

namespace gyro {

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
  T lever;                   ///< I* (ai/Ii - aj/Ij), a the arms: of friction on the relative rolling [m]
  T damping_rate;            ///< Qi/mi + Qj/mj, Q the sum of all dashpots of a body, see largest_dashpot() [1/s]
};

/// History that every contact keeps from one step to the next. Zero for a new contact.
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

/// History that only some laws keep. A scene whose laws need none of it has no memory for it. Zero for a new contact.
template <class T>
struct ExtraHistory {
  T max_overlap;         ///< largest overlap so far: hysteretic normal force [m]
  Vec3<T> roll_elastic;  ///< elastic rolling torque on i: rolling spring [N m]
  Vec3<T> roll_drag;     ///< damping torque on i: for the ledger alone [N m]

  template <class F, class... H>
  static constexpr void for_each_field(F&& f, H&... h) {
    f("max_overlap", h.max_overlap...);
    f("roll_elastic", h.roll_elastic...);
    f("roll_drag", h.roll_drag...);
  }
};
static_assert(declares_every_field<ExtraHistory<float>>);

/// Loads on body i, the new history, and what the ledger needs.
template <class T>
struct ContactLoad {
  Vec3<T> force;              ///< on i; j receives the opposite [N]
  Vec3<T> couple;             ///< rolling resistance on i; j receives the opposite [N m]
  ContactHistory<T> history;  ///< for the next step
  T damped;                   ///< work lost to damping in this step, of dashpots and of hysteresis [J]
  T slipped;                  ///< work lost to friction and rolling in this step [J]
  T dashpot;                  ///< q of largest_dashpot(): its part in the Q of both bodies [N s/m]
};

/// Result of a normal law, with all that the tangential and the rolling law need to know of it.
template <class T>
struct NormalLoad {
  T push;                  ///< force that presses the bodies apart, >= 0 [N]
  T spring;                ///< its elastic part: push - spring is the dashpot's [N]
  T stiffness;             ///< of the normal spring, now [N/m]
  T tangential_stiffness;  ///< of the tangential spring that belongs to it, now [N/m]
  T stiffening;  ///< that over its value at the last step; of a new contact any finite number, for it remembers no load
                 ///< [-]
  T tangential_damping;  ///< coefficient of the tangential dashpot [N s/m]
  T dashpot;             ///< q of largest_dashpot(), without the cap [N s/m]
  T unloading;           ///< factor on remembered tangential loads: falls with the stiffness [-]
  T damped;              ///< work lost to hysteresis in this step [J]
};

/// Stiffnesses of a contact that limit the step, and the damping ratio of its dashpots.
struct ContactStiffness {
  double normal, tangential;  ///< [N/m]
  double rolling;             ///< [N m/rad]
  double damping;             ///< c/(2 sqrt(S m*)), normal and tangential [-]
  double margin;              ///< normal is so many times the largest of the spring, so that a step resolves it [-]
};

/// A remembered vector laid into the present tangent plane at equal size: the contact has rolled along. One that stands
/// on the plane within 1e-6 rad becomes shorter.
/// @param size2  square of its size
template <class T>
GYRO_HD Vec3<T> laid_into_plane(const Vec3<T>& remembered, T size2, const Vec3<T>& normal) {
  using std::sqrt;
  const Vec3<T> flat = tangential(remembered, normal);
  return sqrt(size2 / larger(norm2(flat), T(1e-12) * size2 + T(1e-30))) * flat;
}

/// Share of a vector of this size that a limit leaves, 1 below it.
template <class T>
GYRO_HD T share_within(T size, T limit) {
  return select(size > limit, limit / larger(size, T(1e-30)), T(1));
}

}  // namespace gyro
