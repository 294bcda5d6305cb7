// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/solver.hpp"

// What happens to a scene between windows: rock comes and goes, readings are taken, the state is saved.

namespace gyro {

template <class Exec, class Real>
void DemSolver<Exec, Real>::insert(std::span<const NewRock> rocks) {
  EnergyTerms& energies = monitor_.energies();
  Arrivals<Real> arrivals(rock_.present(), scene_, energies.exchanged);
  arrivals.reserve(rocks);
  for (const NewRock& rock : rocks) arrivals.add(rock);
  rock_.append(arrivals);
  rigid_.append(rocks, rock_);
  lists_.extend(rock_.count());
  energies.exchanged = arrivals.exchanged();
  monitor_.counts().bonds_intact += arrivals.bonds_intact();
  monitor_.add_bonds_in_step(arrivals.bonds_in_step());
  monitor_.reserve_events(rock_.bond_count());
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::remove(std::span<const ParticleId> ids) {
  if (ids.empty()) return;
  const EnergyTerms& booked = monitor_.energies();
  const BondSums bonds_before = sums().bonds();
  const EnergyTerms before = sums().energy(booked, sums().particles(), sums().contacts(), bonds_before);
  const Remaining remaining(Exec::host(rock_.particles().id), ids);
  monitor_.book_losses(Exec::host(rock_.particles().losses), remaining);
  lists_.rearrange(remaining);
  accounts_.set_entries(lists_.walls().count());
  rigid_.rearrange(remaining, rock_.keep(remaining), rock_);
  monitor_.reserve_events(rock_.bond_count());

  const BondSums bonds_after = sums().bonds();
  monitor_.counts().bonds_intact -= bonds_before.intact - bonds_after.intact;
  monitor_.add_bonds_in_step(bonds_after.in_step - bonds_before.in_step);
  const EnergyTerms after = sums().energy(booked, sums().particles(), sums().contacts(), bonds_after);
  const auto state = [](const EnergyTerms& e) { return e.kinetic + e.potential + e.contact_elastic + e.bond_elastic; };
  monitor_.energies().exchanged -= state(before) - state(after);
}

template <class Exec, class Real>
Balance DemSolver<Exec, Real>::balance() const {
  const ParticleSums particles = sums().particles();
  const ContactSums contacts = sums().contacts();
  return {.energy = sums().energy(monitor_.energies(), particles, contacts, sums().bonds()),
          .extremes = extremes(particles, contacts),
          .momentum = particles.momentum};
}

template <class Exec, class Real>
Extremes DemSolver<Exec, Real>::extremes(const ParticleSums& particles, const ContactSums& contacts) const {
  Extremes x = monitor_.worst(sums().extremes(particles, contacts));
  if (lists_.smallest_radius() > 0 && walls_.largest_step() > 0) {
    x.wall_step = walls_.largest_step() / lists_.smallest_radius();
    x.fast_wall = walls_.fastest();
  }
  return x;
}

template <class Exec, class Real>
Counts DemSolver<Exec, Real>::counts() const {
  Counts c = monitor_.counts();
  c.particles = rock_.count();
  if constexpr (has_levels)
    if (rigid_.in_use()) c.rigid_particles = rigid_.count(exec_, rock_).particles;
  return c;
}

template <class Exec, class Real>
SavedState DemSolver<Exec, Real>::save() const {
  SavedState s;
  rock_.save(s);
  rigid_.save(s);
  lists_.save(s);
  walls_.save(s);
  accounts_.save(s);
  monitor_.save(s);
  s.put_one("dem/primed", std::uint8_t{primed_});
  return s;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::restore(const SavedState& saved) {
  rock_.restore(saved);
  rigid_.restore(saved, rock_);
  lists_.restore(exec_, saved, rock_);
  walls_.restore(saved);
  accounts_.restore(saved, lists_.walls().count());
  monitor_.restore(saved);
  monitor_.reserve_events(rock_.bond_count());
  primed_ = saved.get_one<std::uint8_t>("dem/primed") != 0;
}

}  // namespace gyro
