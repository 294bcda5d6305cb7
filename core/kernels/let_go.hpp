// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/bond_forces.hpp"
#include "core/kernels/bond_lane.hpp"
#include "core/laws/bond/models.hpp"
#include "core/laws/contact/models.hpp"
#include "core/laws/contact/scene_contacts.hpp"

namespace gyro {

/// Broken bonds whose ends still touch, pressed by next to nothing: they become ordinary contacts, so that what they
/// held together in one block can be divided.
///
/// A pressed bond pushes from the length that it had, with its own stiffness; a contact pushes from where the spheres
/// touch, and is softer. So a bond is let go only if the elastic energies of both are small beside that which breaks it
/// in tension,
///
///   max(E_pressed, E_contact) <= share (f sigma_t A)^2 / (2 k_n A)
///
/// which makes the force at most sqrt(share) of that at failure. Both are taken without the friction of the contact,
/// which begins without history. A map over bonds; let_go() changes the bond, difference() is E_pressed - E_contact.
template <class Real>
struct LetGo {
  ConstParticleView p;
  ConstBondView<Real> b;
  std::int32_t* state;  ///< the same column as in b, to be changed
  const Block* blocks;
  BondConstants<Real> law;
  BondModel model;
  ContactConstants<Real> contact;
  ContactModel contact_model;
  double share;  ///< [-]

  struct Energies {
    double pressed, contact, breaking;  ///< [J]
  };

  /// Of one bond; the map of a sum.
  GYRO_HD double operator()(Index n) const {
    if (!may_go(n)) return 0;
    const Energies e = energies(n);
    return is_small(e) ? e.pressed - e.contact : 0;
  }
  GYRO_HD void let_go(Index n) const {
    if (may_go(n) && is_small(energies(n))) state[n] = bond_broken;
  }

 private:
  GYRO_HD bool may_go(Index n) const {
    if (b.state[n] != bond_pressed) return false;
    const Block& block = blocks[p.block[b.i[n]]];
    return block.free_of_load && !block.rigid;
  }
  GYRO_HD bool is_small(const Energies& e) const { return larger(e.pressed, e.contact) <= share * e.breaking; }

  GYRO_HD Energies energies(Index n) const {
    BondLanes<Real, OneLane> bond(OneLane{n}, p, b);
    bond.carry_axes(OneLane{n}, p, b, b.state[n], 0);
    const double pressed = static_cast<double>(bond_load(model, law, bond, true).elastic);
    const Sphere i = p.position[b.i[n]], j = p.position[b.j[n]];
    const double overlap = larger(i.radius + j.radius - norm(j.x - i.x), 0.0);
    const ContactHistory<Real> fresh{};
    const ExtraHistory<Real> extra{};
    const double touching = static_cast<double>(
        contact_energy(contact_model, contact, static_cast<Real>(i.radius * j.radius / (i.radius + j.radius)),
                       static_cast<Real>(overlap), fresh, &extra));
    const double area = 3.14159265358979323846 * static_cast<double>(b.radius[n]) * static_cast<double>(b.radius[n]);
    const double stiffness = static_cast<double>(
        stiffness_per_area(law.bond.normal_stiffness, law.bond.normal_modulus, static_cast<Real>(b.length[n])));
    const double stress = static_cast<double>(b.strength[n]) * static_cast<double>(law.bond.tensile_strength);
    return {pressed, touching, 0.5 * stress * stress * area / stiffness};
  }
};

/// For each bond.
template <class Real>
struct LetGoEach {
  LetGo<Real> kernel;
  GYRO_HD void operator()(Index n) const { kernel.let_go(n); }
};

}  // namespace gyro
