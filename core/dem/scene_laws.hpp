// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/laws/bond/constants.hpp"
#include "core/laws/contact/models.hpp"
#include "core/laws/contact/scene_contacts.hpp"

#include <vector>

namespace gyro {

/// Owns the choice of a scene's laws and their constants, as kernels take them.
template <class Exec, class Real>
class SceneLaws {
 public:
  explicit SceneLaws(const Scene& scene)
      : rock_(contact_constants<Real>(scene, scene.rock_material, scene.rock_material)),
        rock_model_(gyro::rock_model(scene)),
        wall_model_(gyro::wall_model(scene)),
        bond_model_(scene.bond_model),
        bond_(scene.bonds ? cast<Real>(bond_constants(scene)) : BondConstants<Real>{}) {
    std::vector<ContactConstants<Real>> walls;
    for (const Wall& wall : scene.walls)
      walls.push_back(contact_constants<Real>(scene, scene.rock_material, wall.material));
    Exec::upload(walls_, std::move(walls));
  }

  const ContactConstants<Real>& rock() const { return rock_; }           ///< of two particles
  const ContactConstants<Real>* walls() const { return walls_.data(); }  ///< of a particle and each wall
  ContactModel rock_model() const { return rock_model_; }
  ContactModel wall_model() const { return wall_model_; }
  BondModel bond_model() const { return bond_model_; }
  const BondConstants<Real>& bond() const { return bond_; }  ///< zero without bonds

 private:
  ContactConstants<Real> rock_;
  ContactModel rock_model_, wall_model_;
  BondModel bond_model_;
  BondConstants<Real> bond_;
  typename Exec::template Buffer<ContactConstants<Real>> walls_;
};

}  // namespace gyro
