// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/kernels/bond_forces.hpp"
#include "core/kernels/bond_lane.hpp"
#include "core/laws/bond/models.hpp"
#include "core/laws/bond/section.hpp"
#include "core/laws/contact/models.hpp"

namespace gyro {

/// Broken bonds whose ends still touch, pressed by next to nothing: they become ordinary contacts, so that what they
/// held together in one block can be divided.
///
/// A pressed bond pushes from the length that it had, with its own stiffness; a contact pushes from where the spheres
/// touch, with its own. So a bond is let go only if the elastic energies of both are small beside that which breaks it
/// in tension,
///
///   max(E_pressed, E_contact) <= share (f sigma_t A)^2 / (2 k_n A)
///
/// The force is then at most sqrt(share) of that at failure where the contact is softer than the bond, as in rock.
/// Under laws with history (hysteretic force, rolling springs) a contact cannot begin with an overlap, and the bond is
/// let go only where the spheres do not touch.
///
/// A map over bonds: what letting go loses [J], E_pressed - E_contact less what the force of the bond, which is still
/// in the loads, does in the next half kick.
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

  bool with_history;  ///< the contact law keeps ExtraHistory

  struct Energies {
    double pressed, contact, breaking;  ///< [J]
    double next_work;                   ///< of the bond's force in the next half kick [J]
  };

  GYRO_HD double operator()(Index n) const {
    if (!may_go(n)) return 0;
    const Energies e = energies(n);
    return is_small(e) ? e.pressed - e.contact - e.next_work : 0;
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
    const BondLoad<Real> load = bond_load(model, law, bond, true);
    const double pressed = static_cast<double>(load.elastic);
    const double next_work = 0.5 * p.step[b.i[n]] * static_cast<double>(bond_power(load, bond.rates));
    const Sphere i = p.position[b.i[n]], j = p.position[b.j[n]];
    const double overlap = larger(i.radius + j.radius - norm(j.x - i.x), 0.0);
    if (with_history && overlap > 0) return {0, 1, 0, 0};
    const ContactHistory<Real> fresh{};
    if (overlap == 0) return {pressed, 0, breaking_energy(n), next_work};
    const ExtraHistory<Real>* const extra = nullptr;  // the law keeps none
    const double touching = static_cast<double>(
        contact_energy(contact_model, contact, static_cast<Real>(i.radius * j.radius / (i.radius + j.radius)),
                       static_cast<Real>(overlap), fresh, extra));
    return {pressed, touching, breaking_energy(n), next_work};
  }
  /// In tension [J].
  GYRO_HD double breaking_energy(Index n) const {
    const double area = 3.14159265358979323846 * static_cast<double>(b.radius[n]) * static_cast<double>(b.radius[n]);
    const double stiffness = static_cast<double>(
        stiffness_per_area(law.bond.normal_stiffness, law.bond.normal_modulus, static_cast<Real>(b.length[n])));
    const double stress = static_cast<double>(b.strength[n]) * static_cast<double>(law.bond.tensile_strength);
    return 0.5 * stress * stress * area / stiffness;
  }
};

/// For each bond.
template <class Real>
struct LetGoEach {
  LetGo<Real> kernel;
  GYRO_HD void operator()(Index n) const { kernel.let_go(n); }
};

}  // namespace gyro
