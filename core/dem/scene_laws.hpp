// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/contact_laws.hpp"
#include "core/laws/bond.hpp"

#include <vector>

namespace gyro {

/// Constants of the bonds of a scene that has them.
inline BondLaw<double> bond_law(const Scene& scene) {
  const BondParameters& b = *scene.bonds;
  const auto rock = static_cast<std::size_t>(scene.rock_material);
  return {.normal_stiffness = b.normal_stiffness,
          .shear_stiffness = b.shear_stiffness,
          .normal_modulus = b.normal_modulus,
          .shear_modulus = b.shear_modulus,
          .tensile_strength = b.tensile_strength,
          .shear_strength = b.shear_strength,
          .damping = b.damping,
          .friction = scene.pairs[rock * scene.materials.size() + rock].friction,
          .dt = scene.dt};
}

/// Owns the constants of a scene's laws, as kernels take them.
template <class Exec, class Real>
class SceneLaws {
 public:
  explicit SceneLaws(const Scene& scene)
      : rock_(contact_law<Real>(scene, scene.rock_material, scene.rock_material)),
        bond_(scene.bonds ? cast<Real>(bond_law(scene)) : BondLaw<Real>{}) {
    std::vector<ContactLaw<Real>> walls;
    for (const Wall& wall : scene.walls) walls.push_back(contact_law<Real>(scene, scene.rock_material, wall.material));
    Exec::upload(walls_, std::move(walls));
  }

  const ContactLaw<Real>& rock() const { return rock_; }           ///< of two particles
  const ContactLaw<Real>* walls() const { return walls_.data(); }  ///< of a particle and each wall
  const BondLaw<Real>& bond() const { return bond_; }              ///< zero without bonds

 private:
  ContactLaw<Real> rock_;
  BondLaw<Real> bond_;
  typename Exec::template Buffer<ContactLaw<Real>> walls_;
};

}  // namespace gyro
