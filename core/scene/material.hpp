// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/fields.hpp"
#include "core/scene/contact_model.hpp"

#include <string>

namespace gyro {

/// Elastic solid. E = 2 G (1 + nu).
struct Material {
  std::string name;
  double density = 0;        ///< [kg/m3]
  double shear_modulus = 0;  ///< G [Pa]
  double poisson_ratio = 0;  ///< nu [-]
};

/// Surface properties of a pair of materials. A number takes its value from the key `contacts.<pair>.<name of the
/// field>`, if the pair has it.
struct PairProperties {
  double friction = 0;          ///< Coulomb coefficient [-]
  double restitution = 1;       ///< of a normal impact, in (0, 1] [-]
  double rolling_friction = 0;  ///< rolling torque <= coefficient x R* x normal force [-]
  ContactModel model{};         ///< law of the normal force and of rolling resistance

  template <class F, class... P>
  static constexpr void for_each_field(F&& f, P&... p) {
    f("friction", p.friction...);
    f("restitution", p.restitution...);
    f("rolling_friction", p.rolling_friction...);
    f("model", p.model...);
  }
};
static_assert(declares_every_field<PairProperties>);

}  // namespace gyro
