// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"
#include "core/scene/bond_parameters.hpp"

// What every bond law reads and returns. All laws work on single numbers and on packs.

namespace gyro {

/// Constants of all bonds of a scene. All laws read this one set.
template <class T>
struct BondConstants {
  BondParametersOf<T> bond;
  T friction;  ///< Coulomb coefficient mu of a pressed bond [-]
  T dt;        ///< time step: velocities are dt/2 older than positions [s]
};

/// Section and strength of one bond.
template <class T>
struct BondSection {
  T radius;        ///< Rb of the circular section [m]
  T strength;      ///< f, factor on both strengths [-]
  T sqrt_mass;     ///< sqrt(m_i m_j / (m_i + m_j)) [kg^1/2]
  T sqrt_inertia;  ///< sqrt(I_i I_j / (I_i + I_j)) [kg^1/2 m]
  T arm;           ///< a_i, as in BondShape [-]
  T length;        ///< L0 [m]
};

/// Velocities of the two ends of a bond, half a step before the positions. World frame.
template <class T>
struct BondRates {
  Vec3<T> velocity;                                ///< v_j - v_i [m/s]
  Vec3<T> angular_velocity_i, angular_velocity_j;  ///< [rad/s]
};

/// Loads of a bond and what the ledger needs. World frame.
template <class T>
struct BondLoad {
  Vec3<T> force;     ///< on j; i receives the opposite [N]
  Vec3<T> torque_i;  ///< on i [N m]
  Vec3<T> torque_j;  ///< on j [N m]
  T tension_ratio;   ///< tensile stress / strength; a bond fails at 1 [-]
  T shear_ratio;     ///< shear stress / strength; a bond fails at 1 [-]
  T elastic;         ///< stored energy [J]
  T damped;          ///< work lost to damping in this step [J]
};

/// Power of a bond's loads on its two ends [W].
template <class T>
GYRO_HD T bond_power(const BondLoad<T>& load, const BondRates<T>& rates) {
  return dot(load.force, rates.velocity) + dot(load.torque_i, rates.angular_velocity_i) +
         dot(load.torque_j, rates.angular_velocity_j);
}

namespace bond_detail {

struct CastField {
  template <class To, class From>
  constexpr void operator()(const char*, To& to, const From& from) const {
    to = static_cast<To>(from);
  }
};

}  // namespace bond_detail

/// The same constants in another number type, or one copy for each lane of a pack. For the host.
template <class To, class From>
BondConstants<To> cast(const BondConstants<From>& law) {
  BondConstants<To> out;
  BondParametersOf<To>::for_each_field(bond_detail::CastField{}, out.bond, law.bond);
  out.friction = static_cast<To>(law.friction);
  out.dt = static_cast<To>(law.dt);
  return out;
}

}  // namespace gyro
