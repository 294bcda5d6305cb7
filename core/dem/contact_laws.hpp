// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/hertz_mindlin.hpp"
#include "core/laws/restitution.hpp"
#include "core/scene/scene.hpp"

namespace gyro {

/// Constants of the contact of two materials. E = 2 G (1 + nu).
template <class Real>
ContactLaw<Real> contact_law(const Scene& scene, Index a, Index b) {
  const Material &m = scene.materials[static_cast<std::size_t>(a)], &n = scene.materials[static_cast<std::size_t>(b)];
  const PairProperties& pair =
      scene.pairs[static_cast<std::size_t>(a) * scene.materials.size() + static_cast<std::size_t>(b)];
  const auto plane_compliance = [](const Material& x) {
    return (1 - x.poisson_ratio * x.poisson_ratio) / (2 * x.shear_modulus * (1 + x.poisson_ratio));
  };
  const auto shear_compliance = [](const Material& x) { return (2 - x.poisson_ratio) / x.shear_modulus; };
  ContactLaw<Real> law;
  law.youngs = static_cast<Real>(1 / (plane_compliance(m) + plane_compliance(n)));
  law.shear = static_cast<Real>(1 / (shear_compliance(m) + shear_compliance(n)));
  law.damping = static_cast<Real>(damping_for_restitution(pair.restitution));
  law.friction = static_cast<Real>(pair.friction);
  law.rolling = static_cast<Real>(pair.rolling_friction);
  law.dt = static_cast<Real>(scene.substeps * scene.dt);
  return law;
}

}  // namespace gyro
