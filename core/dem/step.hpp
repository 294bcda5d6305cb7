// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/solver.hpp"

// One window and one step of the DEM.

namespace gyro {

template <class Exec, class Real>
void DemSolver<Exec, Real>::advance(const Window& window, const MantlePath& path) {
  if (window.steps % scene_.substeps != 0)
    throw BadInput("a window of " + std::to_string(window.steps) + " steps is not a whole number of holds of " +
                   std::to_string(scene_.substeps) + " steps");
  GYRO_EXPECT(window.dt == scene_.dt && window.steps > 0);
  walls_.plan(scene_.walls, window, path, scene_.substeps);
  monitor_.begin_window();
  if (!primed_) prime();
  for (int k = 1; k <= window.steps; ++k) {
    if (give_up_ && give_up_(static_cast<double>(k - 1) / window.steps))
      throw WindowGivenUp("the window from t = " + std::to_string(window.begin()) + " s on was given up");
    walls_.go_to_step(k);
    step(window.first_step + k, {(k - 1) % scene_.substeps == 0, k + scene_.substeps > window.steps});
  }
  walls_.end_window();
  close_window(window);
}

/// Velocity Verlet:
///
///   move      v(n+1/2) = v(n) + dt/2 F(n)/m,  x(n+1) = x(n) + dt v(n+1/2), rotations alike
///   forces    F(n+1) of bonds, pairs and walls, from x(n+1) and v(n+1/2)
///   gather    v(n+1) = v(n+1/2) + dt/2 F(n+1)/m
///
/// With holds of several steps, contact and wall forces are evaluated in the first step of a hold only, for the
/// positions in its middle.
template <class Exec, class Real>
void DemSolver<Exec, Real>::step(std::int64_t number, const StepInHold& hold) {
  move();
  if (hold.first) watch();
  if (rock_.has_bonds()) bond_forces(number);
  if (hold.first) contact_forces(half_hold_offset(), hold.last ? carry_over_fraction() : 0);
  gather(hold.first, true);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::move() {
  const double allowed = lists_.allowed_distance();
  exec_.for_each("move", rock_.count(),
                 Move{.p = rock_.view(),
                      .dt = scene_.dt,
                      .half_hold_offset = half_hold_offset(),
                      .allowed2 = allowed * allowed,
                      .stale = &monitor_.flags()->moved_too_far,
                      .with_orientation = rock_.has_bonds(),
                      .hold_time = scene_.hold_time(),
                      .limits = scene_.limits,
                      .limit_exceeded = &monitor_.flags()->limit_exceeded});
}

/// Keeps the first excess of a limit, and rebuilds the neighbour lists if a particle or a wall has moved too far or a
/// rock has cracked.
template <class Exec, class Real>
void DemSolver<Exec, Real>::watch() {
  const StepFlags flags = monitor_.raised();
  if (flags.limit_exceeded) keep_excess();
  if (!lists_.valid() || flags.moved_too_far || flags.block_cracked || walls_.moved_beyond(lists_.allowed_distance()))
    rebuild_lists();
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::rebuild_lists() {
  accounts_.add_up(exec_, lists_.walls().entries());
  lists_.rebuild(exec_, rock_, walls_.now());
  accounts_.set_entries(lists_.walls().count());
  walls_.store_listed();
  monitor_.lists_rebuilt();
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::bond_forces(std::int64_t number) {
  with_bond_law(laws_.bond_model(), [&]<class Law>(Law) {
    exec_.for_each_block("bond forces", rock_.block_launch(),
                         BondForces<Real, Law>{.p = rock_.read(),
                                               .loads = rock_.view().bond_load,
                                               .b = rock_.bond_view(),
                                               .list = rock_.block_list(),
                                               .law = laws_.bond(),
                                               .log = monitor_.break_log(scene_.limits.bond_rotation),
                                               .step = number});
  });
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::contact_forces(double half_hold_offset, double carry_over) {
  scene_.substeps == 1 ? launch_contacts<false>(half_hold_offset, carry_over)
                       : launch_contacts<true>(half_hold_offset, carry_over);
}

template <class Exec, class Real>
template <bool held>
void DemSolver<Exec, Real>::launch_contacts(double half_hold_offset, double carry_over) {
  GYRO_EXPECT(lists_.valid());
  const OverlapCheck deep{scene_.limits.overlap_ratio, &monitor_.flags()->limit_exceeded};
  with_contact_law(laws_.rock_model(), [&]<class Law>(Law) {
    exec_.for_each("pair forces", lists_.pairs().count(),
                   PairForces<Real, Law, held>{.p = rock_.read(),
                                               .pairs = lists_.pairs().view(),
                                               .bond_state = rock_.bond_state(),
                                               .constants = laws_.rock(),
                                               .half_hold_offset = half_hold_offset,
                                               .deep = deep});
  });
  with_contact_law(laws_.wall_model(), [&]<class Law>(Law) {
    exec_.for_each("wall forces", lists_.walls().count(),
                   WallForces<Real, Law, held>{.p = rock_.read(),
                                               .walls = walls_.now(),
                                               .near = lists_.walls().view(),
                                               .booking = accounts_.booking(),
                                               .constants = laws_.walls(),
                                               .dt = scene_.hold_time(),
                                               .half_hold_offset = half_hold_offset,
                                               .carry_over = carry_over,
                                               .deep = deep});
  });
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::gather(bool contacts_are_new, bool kick) {
  if (scene_.substeps > 1) held_.resize(static_cast<std::size_t>(rock_.count()));
  exec_.for_each("gather", rock_.count(),
                 Gather<Real>{.p = rock_.view(),
                              .pairs = lists_.pairs().read(),
                              .walls = lists_.walls().read(),
                              .gravity = scene_.gravity,
                              .dt = scene_.dt,
                              .with_bonds = rock_.has_bonds(),
                              .held = scene_.substeps > 1 ? held_.data() : nullptr,
                              .first_of_hold = contacts_are_new,
                              .kick = kick});
}

/// Loads at the very start, so that the first half kick is a real one. No time passes: what the walls book is
/// discarded, but for what the first half kick will do.
template <class Exec, class Real>
void DemSolver<Exec, Real>::prime() {
  primed_ = true;
  rebuild_lists();
  EnergyTerms& energies = monitor_.energies();
  energies.exchanged += sums().bonds().elastic;  // before any bond fails
  if (rock_.has_bonds()) bond_forces(0);
  contact_forces(0, carry_over_fraction());
  gather(true, false);
  accounts_.discard(exec_, lists_.walls().entries());
  accounts_.carry_over(exec_, lists_.walls().entries(), where_rock_is(), walls_.poses());
  energies.exchanged += sums().contacts().elastic;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::close_window(const Window& window) {
  const auto& entries = lists_.walls().entries();
  accounts_.close(exec_, entries, where_rock_is(), walls_.poses(), window.length());
  for (const WallLoad& load : accounts_.loads()) monitor_.energies().wall_work += load.work;
  accounts_.carry_over(exec_, entries, where_rock_is(), walls_.poses());
  Counts& counts = monitor_.counts();
  counts.particle_steps += std::int64_t{rock_.count()} * (window.steps / scene_.substeps);
  counts.bond_steps += counts.bonds_intact * window.steps;
  monitor_.collect_breakages(rock_, window.dt);
  if (monitor_.raised().limit_exceeded) keep_excess(), monitor_.lower_limit_flag();
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_excess() {
  if (!monitor_.has_excess()) monitor_.keep_excess(sums().extremes(true));
}

}  // namespace gyro
