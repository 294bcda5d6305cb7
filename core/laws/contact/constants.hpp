// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/contact/restitution.hpp"
#include "core/scene/material.hpp"

namespace gyro {

/// Constants of one pair of materials, combined once. All contact laws read this one set.
template <class T>
struct ContactConstants {
  T youngs;       ///< E* [Pa], 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
  T shear;        ///< G* [Pa], 1/G* = (2 - nu1)/G1 + (2 - nu2)/G2
  T damping;      ///< zeta >= 0 of the dashpots [-], from the restitution: damping_for_restitution()
  T friction;     ///< Coulomb coefficient mu [-]
  T rolling;      ///< rolling friction mu_r [-]
  T dt;           ///< time for which the forces act: the step, or the hold of several sub-steps [s]
  T unloading;    ///< 1/e^2 >= 1: unloading over loading stiffness of a hysteretic spring [-]
  T max_rate;     ///< beta/dt: damping rate that all dashpots of a particle may have together [1/s]
  T youngs_root;  ///< sqrt(2 E*), once for all contacts: of the normal dashpot of Hertz [Pa^0.5]
  T shear_root;   ///< sqrt(8 G*), of its tangential dashpot [Pa^0.5]

  template <class F, class... C>
  static constexpr void for_each_field(F&& f, C&... c) {
    f("youngs", c.youngs...);
    f("shear", c.shear...);
    f("damping", c.damping...);
    f("friction", c.friction...);
    f("rolling", c.rolling...);
    f("dt", c.dt...);
    f("unloading", c.unloading...);
    f("max_rate", c.max_rate...);
    f("youngs_root", c.youngs_root...);
    f("shear_root", c.shear_root...);
  }
};
static_assert(declares_every_field<ContactConstants<double>>);

/// The same constants in another number type, or one copy for each lane of a pack. For the host.
template <class To, class From>
ContactConstants<To> cast(const ContactConstants<From>& law) {
  ContactConstants<To> out;
  ContactConstants<To>::for_each_field([](const char*, To& to, const From& from) { to = static_cast<To>(from); }, out,
                                       law);
  return out;
}

/// Constants of the contact of materials m and n, E = 2 G (1 + nu). Host only.
/// @param hold_time    time for which the forces act [s]
/// @param damping_cap  beta of largest_dashpot() [-]
template <class Real>
ContactConstants<Real> contact_constants(const Material& m, const Material& n, const PairProperties& pair,
                                         double hold_time, double damping_cap = 1) {
  const auto plane_compliance = [](const Material& x) {
    return (1 - x.poisson_ratio * x.poisson_ratio) / (2 * x.shear_modulus * (1 + x.poisson_ratio));
  };
  const auto shear_compliance = [](const Material& x) { return (2 - x.poisson_ratio) / x.shear_modulus; };
  const double youngs = 1 / (plane_compliance(m) + plane_compliance(n)),
               shear = 1 / (shear_compliance(m) + shear_compliance(n));
  return {.youngs = static_cast<Real>(youngs),
          .shear = static_cast<Real>(shear),
          .damping = static_cast<Real>(damping_for_restitution(pair.restitution)),
          .friction = static_cast<Real>(pair.friction),
          .rolling = static_cast<Real>(pair.rolling_friction),
          .dt = static_cast<Real>(hold_time),
          .unloading = static_cast<Real>(1 / (pair.restitution * pair.restitution)),
          .max_rate = static_cast<Real>(damping_cap / hold_time),
          .youngs_root = static_cast<Real>(std::sqrt(2 * youngs)),
          .shear_root = static_cast<Real>(std::sqrt(8 * shear))};
}

}  // namespace gyro
