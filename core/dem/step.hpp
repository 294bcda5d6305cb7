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
  const int hold = scene_.substeps;
  for (int done = 0; done < window.steps; done += hold) {
    if (give_up_ && give_up_(static_cast<double>(done) / window.steps))
      throw WindowGivenUp("the window from t = " + std::to_string(window.begin()) + " s on was given up");
    walls_.go_to_step(done + 1);
    advance_to_hold(window.first_step + done + 1, done == 0);
    watch();
    contact_forces(half_hold_offset(), done + hold == window.steps ? carry_over_fraction() : 0);
  }
  if (hold > 1) advance_rocks(Motions::move_on, window.first_step + window.steps - hold + 2, hold - 1);
  finish_step(hold == 1, true);
  walls_.go_to_step(window.steps);
  walls_.end_window();
  close_window(window);
}

/// Velocity Verlet:
///
///   move      v(n+1/2) = v(n) + dt/2 F(n)/m,  x(n+1) = x(n) + dt v(n+1/2), rotations alike
///   forces    F(n+1) of bonds, pairs and walls, from x(n+1) and v(n+1/2)
///   finish    v(n+1) = v(n+1/2) + dt/2 F(n+1)/m
///
/// What happens between two evaluations of contact and wall forces concerns each rock alone, and is done rock by rock:
/// finish, move, bond forces. With holds of several steps, contact and wall forces are evaluated in the first step of
/// a hold only, for the positions in its middle.
/// @param step  number of the first step of a hold, at which this ends
template <class Exec, class Real>
void DemSolver<Exec, Real>::advance_to_hold(std::int64_t step, bool first_of_window) {
  if (first_of_window)
    advance_rocks(Motions::move, step, 1);
  else
    advance_rocks(Motions::move_on, step - scene_.substeps + 1, scene_.substeps);
}

/// @param first   motions in the first of the steps; in later ones contact forces are held
/// @param step    number of the first one
/// @param passes  number of steps
template <class Exec, class Real>
void DemSolver<Exec, Real>::advance_rocks(Motions first, std::int64_t step, int passes) {
  if (scene_.substeps > 1) held_.resize(static_cast<std::size_t>(rock_.count()));
  with_bond_law(laws_.bond_model(), [&]<class Law>(Law) {
    const BondForces<Real, Law> bonds{.p = rock_.read(),
                                      .loads = rock_.view().bond_load,
                                      .b = rock_.bond_view(),
                                      .blocks = rock_.block_view(),
                                      .law = laws_.bond(),
                                      .log = monitor_.break_log(scene_.limits.bond_rotation)};
    AdvanceRocks<Real, Law> kernel{.pieces = rock_.pieces(),
                                   .blocks = rock_.block_view(),
                                   .colour_begin = rock_.colour_begin(),
                                   .gather = gather(),
                                   .move = move(),
                                   .bonds = bonds,
                                   .first = first,
                                   .step = step};
    BlockLaunch launch = rock_.piece_launch();
    launch.passes = passes;
    exec_.for_each_block("advance rocks", launch, kernel);
    kernel.pieces = rock_.large_rows();
    for (int pass = 0; pass < passes && !rock_.large_rocks().empty(); ++pass) {
      exec_.for_each_block("advance rocks", rock_.large_launch(), kernel);
      for (const auto& large : rock_.large_rocks())
        exec_.for_each_colour("bonds of large rocks", large.colour_begin,
                              LargeRockBonds<Real, Law>{bonds, large.block, kernel.step});
      kernel.first = Motions::move_held;
      ++kernel.step;
    }
  });
}

template <class Exec, class Real>
Move DemSolver<Exec, Real>::move() {
  const double allowed = lists_.allowed_distance();
  return {.p = rock_.view(),
          .dt = scene_.dt,
          .half_hold_offset = half_hold_offset(),
          .allowed2 = allowed * allowed,
          .stale = &monitor_.flags()->moved_too_far,
          .with_orientation = rock_.has_bonds(),
          .hold_time = scene_.hold_time(),
          .limits = scene_.limits,
          .limit_exceeded = &monitor_.flags()->limit_exceeded};
}

template <class Exec, class Real>
Gather<Real> DemSolver<Exec, Real>::gather() {
  return {.p = rock_.view(),
          .pairs = lists_.pairs().read(),
          .walls = lists_.walls().read(),
          .gravity = scene_.gravity,
          .with_bonds = rock_.has_bonds(),
          .held = scene_.substeps > 1 ? held_.data() : nullptr};
}

/// @param contacts_are_new  contact and wall forces have been evaluated in this step
/// @param kick              false: only the loads, before the first step of a scene
template <class Exec, class Real>
void DemSolver<Exec, Real>::finish_step(bool contacts_are_new, bool kick) {
  if (scene_.substeps > 1) held_.resize(static_cast<std::size_t>(rock_.count()));
  exec_.for_each(
      "finish step", rock_.count(),
      FinishStep<Real>{.gather = gather(), .dt = scene_.dt, .first_of_hold = contacts_are_new, .kick = kick});
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
    exec_.for_each_picked("pair forces", lists_.pairs().count(),
                          PairForces<Real, Law, held>{.p = rock_.read(),
                                                      .pairs = lists_.pairs().view(),
                                                      .bond_state = rock_.bond_state(),
                                                      .constants = laws_.rock(),
                                                      .half_hold_offset = half_hold_offset,
                                                      .deep = deep});
  });
  with_contact_law(laws_.wall_model(), [&]<class Law>(Law) {
    exec_.for_each_picked("wall forces", lists_.walls().count(),
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

/// Loads at the very start, so that the first half kick is a real one. No time passes: what the walls book is
/// discarded, but for what the first half kick will do.
template <class Exec, class Real>
void DemSolver<Exec, Real>::prime() {
  primed_ = true;
  rebuild_lists();
  EnergyTerms& energies = monitor_.energies();
  energies.exchanged += sums().bonds().elastic;  // before any bond fails
  if (rock_.has_bonds()) advance_rocks(Motions::loads_only, 0, 1);
  contact_forces(0, carry_over_fraction());
  finish_step(true, false);
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
