// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/solver.hpp"

// Levels of detail: rocks and pieces that move as rigid bodies while they are loaded little.

namespace gyro {

/// Brings all particles to the end of a step inside a window, as at the window's end, and makes overloaded rocks
/// particles with bonds. What walls have booked stays right: of the last contact forces each particle takes in all what
/// it would have taken, a part of it before and the rest after.
/// @param done  steps of the window
template <class Exec, class Real>
void DemSolver<Exec, Real>::meet(const Window& window, int done) {
  if (held()) advance_rocks({Motions::move_on, step_number(window, done) - 1, 1, false});
  finish_step(true);
  rigid_.free_overloaded(exec_, rock_, scene_);
  monitor_.rocks_freed();
}

/// Where two windows meet: overloaded rocks become particles with bonds, broken rocks are divided
/// into blocks, calm ones become rigid bodies.
template <class Exec, class Real>
void DemSolver<Exec, Real>::change_levels(const Window& window) {
  rigid_.free_overloaded(exec_, rock_, scene_);
  monitor_.rocks_freed();
  if (rigid_.divides_before(window)) divide_rocks();
  if (!rigid_.any_calm(exec_, rock_)) return;
  const double before = sums().energy_in_places();
  rigid_.stiffen_calm(exec_, rock_, scene_);
  monitor_.energies().switched += before - sums().energy_in_places();
}

/// Makes the pieces of broken rocks rocks of their own.
template <class Exec, class Real>
void DemSolver<Exec, Real>::divide_rocks() {
  monitor_.energies().switched += rigid_.let_go(exec_, rock_, laws_);
  const DividedRocks divided = rock_.divided();
  if (!divided.any()) return;
  lists_.rearrange(divided.places);
  rigid_.rearrange(divided.places, rock_.divide(divided), rock_);
  monitor_.reserve_events(rock_.bond_count());
}

/// @param new_forces  of contacts, since the last step
/// @param look        whether at the loads that they bear
template <class Exec, class Real>
void DemSolver<Exec, Real>::advance_rigid_rocks(bool new_forces, bool look) {
  if (look) {
    rigid_.add_loads(exec_, rock_, gather(), new_forces, &monitor_.flags()->rows_lacking);
    if (monitor_.raised().rows_lacking) {
      const bool overloaded = rigid_.make_rows(exec_, rock_, scene_.gravity);
      monitor_.rows_made(overloaded);
    }
  }
  rigid_.advance(exec_, rock_, gather(), move(), new_forces, look, &monitor_.flags()->rock_overloaded);
}

}  // namespace gyro
