// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/solver.hpp"

// One window and one step of the DEM.

namespace gyro {

/// Part of a step: from the forces of some sub-step to the bond forces of a later one.
template <class Exec, class Real>
struct DemSolver<Exec, Real>::Advance {
  Motions first;          ///< of the first pass
  std::int64_t step;      ///< as AdvanceRocks::step, less the steps that the device counts
  int first_substep = 0;  ///< as in AdvanceRocks
  bool to_next = true;    ///< as in AdvanceRocks
};

/// Velocity Verlet:
///
///   move      v(n+1/2) = v(n) + dt/2 F(n)/m,  x(n+1) = x(n) + dt v(n+1/2), rotations alike
///   forces    F(n+1) of bonds, pairs and walls, from x(n+1) and v(n+1/2)
///   finish    v(n+1) = v(n+1/2) + dt/2 F(n+1)/m
///
/// A rock may take a step of the scene in several sub-steps. Contact and wall forces are evaluated once, after the
/// first of them, for the position in the middle of the time for which they then hold; bond forces in each. What
/// happens between two evaluations of contact and wall forces concerns each rock alone, and is done rock by rock:
/// finish, move, bond forces, as often as the rock has sub-steps.
template <class Exec, class Real>
void DemSolver<Exec, Real>::advance(const Window& window, const MantlePath& path) {
  GYRO_EXPECT(window.dt == scene_.dt && window.steps > 0);
  if constexpr (has_levels)
    if (rigid_.in_use() && primed_) change_levels(window);
  walls_.plan(scene_.walls, window, path);
  if (held()) rock_.loosen_spent_rocks(exec_, scene_.dt, scene_.gravity);
  monitor_.begin_window();
  ahead_.begin_window();
  accounts_.begin_window(walls_.poses());
  if (held()) held_.resize(static_cast<std::size_t>(rock_.count()));
  if (!primed_) prime();
  if constexpr (Exec::runs_ahead)
    take_steps_ahead(window);
  else
    take_steps(window);
  if (held()) advance_rocks({Motions::move_on, step_number(window, window.steps) - 1, 1, false});
  finish_step(true);
  close_window(window);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::take_steps(const Window& window) {
  bool together = true;
  for (int done = 0; done < window.steps; ++done) {
    ask_whether_given_up(window, done);
    walls_.go_to_step(done + 1);
    begin_step(window, done, together);
    watch();
    end_step(done + 1 == window.steps);
    together = rigid_.in_use() && done + 1 < window.steps && monitor_.raised().rock_overloaded;
    if (together) meet(window, done + 1);
  }
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::ask_whether_given_up(const Window& window, int done) const {
  if (give_up_ && give_up_(static_cast<double>(done) / window.steps))
    throw WindowGivenUp("the window from t = " + std::to_string(window.begin()) + " s on was given up");
}

/// Steps of the scene before one of a window, without those that the device counts itself.
template <class Exec, class Real>
std::int64_t DemSolver<Exec, Real>::step_number(const Window& window, int done) {
  return window.first_step + (Exec::runs_ahead ? 0 : done);
}

/// To the positions of the next step, and the bond forces there.
/// @param done      steps of the window
/// @param together  all particles are at the same time
template <class Exec, class Real>
void DemSolver<Exec, Real>::begin_step(const Window& window, int done, bool together) {
  const std::int64_t before = step_number(window, done);
  advance_rocks(together ? Advance{Motions::move, before} : Advance{Motions::move_on, before - 1, 1});
  if constexpr (has_levels)
    if (rigid_.in_use()) advance_rigid_rocks(!together, rigid_.looks_in(before));
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::end_step(bool last_of_window) {
  held() ? contact_forces<true>(last_of_window) : contact_forces<false>(last_of_window);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::advance_rocks(const Advance& what) {
  with_bond_law(laws_.bond_model(), [&]<class Law>(Law) {
    const BondForces<Real, Law> bonds{.p = rock_.read(),
                                      .loads = rock_.view().bond_load,
                                      .b = rock_.bond_view(),
                                      .blocks = rock_.block_view(),
                                      .law = laws_.bond(),
                                      .log = monitor_.break_log(scene_.limits.bond_rotation, ahead_.step())};
    AdvanceRocks<Real, Law> kernel{.pieces = rock_.pieces(),
                                   .blocks = rock_.block_view(),
                                   .colour_begin = rock_.colour_begin(),
                                   .gather = gather(),
                                   .move = move(),
                                   .bonds = bonds,
                                   .first = what.first,
                                   .step = what.step,
                                   .first_substep = what.first_substep,
                                   .to_next = what.to_next};
    exec_.for_each_block("advance rocks", rock_.piece_launch(), kernel);
    for (const auto& large : rock_.large_rocks()) advance_large_rock(large, kernel);
  });
}

/// All threads move the particles of the rock, then they share its bonds, round by round, pass by pass.
template <class Exec, class Real>
template <class Kernel>
void DemSolver<Exec, Real>::advance_large_rock(const LargeRock& rock, Kernel kernel) {
  kernel.pieces = rock_.large_rows() + rock.rows.begin;
  for (int pass = 0; pass < kernel.all_passes(rock.substeps); ++pass) {
    kernel.only_pass = pass;
    exec_.for_each_block("advance rocks", BlockLaunch{rock.rows.end - rock.rows.begin, run_length}, kernel);
    const BondStep when = kernel.when(rock.block, pass, scene_.dt / rock.substeps);
    for (const IndexRange& round : rock.rounds)
      exec_.for_each_block("bonds of large rocks", rock_.part_launch(round),
                           PartBonds{rock_.parts() + round.begin, rock_.colour_begin(), kernel.bonds, when});
  }
}

template <class Exec, class Real>
Move DemSolver<Exec, Real>::move() {
  return {.p = rock_.view(),
          .dt = scene_.dt,
          .bounds = lists_.bounds(),
          .stale = &monitor_.flags()->moved_too_far,
          .with_orientation = rock_.has_bonds(),
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
          .held = held() ? held_.data() : nullptr};
}

/// @param kick  false: only the loads, before the first step of a scene
template <class Exec, class Real>
void DemSolver<Exec, Real>::finish_step(bool kick) {
  exec_.for_each("finish step", rock_.count(),
                 FinishStep<Real>{.gather = gather(),
                                  .dt = scene_.dt,
                                  .kick = kick,
                                  .may_be_rigid = rigid_.in_use() ? rock_.block_view() : nullptr});
  if constexpr (has_levels)
    if (rigid_.in_use() && kick) rigid_.finish_step(exec_, rock_, scene_);
}

/// Keeps the first excess of a limit, and makes the neighbour lists again as far as particles or walls have moved too
/// far for them or a rock has cracked.
template <class Exec, class Real>
void DemSolver<Exec, Real>::watch() {
  const StepFlags flags = monitor_.raised();
  if (flags.limit_exceeded) keep_excess();
  if (!lists_.valid() || flags.block_cracked || walls_.moved_too_far(walls_seen_early())) return rebuild_lists();
  if (!flags.moved_too_far) return;
  if (!lists_.renew_pairs(exec_, rock_, scene_.dt)) return rebuild_lists();
  monitor_.pairs_renewed();
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::rebuild_lists() {
  accounts_.add_up(exec_, lists_.walls().entries());
  lists_.rebuild(exec_, rock_, walls_.now(), scene_.dt, walls_.steps());
  accounts_.set_entries(lists_.walls().count());
  walls_.store_listed(lists_.wall_ways());
  monitor_.lists_rebuilt();
}

template <class Exec, class Real>
template <bool held>
void DemSolver<Exec, Real>::contact_forces(bool last_of_window) {
  GYRO_EXPECT(lists_.valid());
  const OverlapCheck deep{scene_.limits.overlap_ratio, &monitor_.flags()->limit_exceeded};
  with_contact_law(laws_.rock_model(), [&]<class Law>(Law) {
    exec_.for_each_picked("pair forces", lists_.pairs().count(),
                          PairForces<Real, Law, held>{.p = rock_.read(),
                                                      .pairs = lists_.pairs().view(),
                                                      .bond_state = rock_.bond_state(),
                                                      .constants = laws_.rock(),
                                                      .dt = scene_.dt,
                                                      .deep = deep});
  });
  with_contact_law(laws_.wall_model(), [&]<class Law>(Law) {
    exec_.for_each_picked("wall forces", lists_.walls().count(),
                          WallForces<Real, Law, held>{.p = rock_.read(),
                                                      .walls = walls_.now(),
                                                      .near = lists_.walls().view(),
                                                      .booking = accounts_.booking(),
                                                      .constants = laws_.walls(),
                                                      .dt = scene_.dt,
                                                      .last_of_window = last_of_window,
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
  if (rock_.has_bonds()) advance_rocks({Motions::loads_only, 0, -1});
  contact_forces<false>(true);
  finish_step(false);
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
  counts.particle_steps += std::int64_t{rock_.count()} * window.steps;
  RigidCount rigid;
  if constexpr (has_levels) {
    if (rigid_.in_use()) {
      rigid_.find_calm(exec_, rock_, laws_, window.length());
      rigid = rigid_.count(exec_, rock_);
    }
  }
  counts.bond_steps += (monitor_.bonds_in_step() - rigid.bonds_in_step) * window.steps;
  monitor_.collect_breakages(rock_, window.dt);
  if (monitor_.raised().limit_exceeded) keep_excess(), monitor_.lower_limit_flag();
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::keep_excess() {
  if (monitor_.has_excess()) return;
  const SceneSums<Exec, Real> all = sums();
  monitor_.keep_excess(all.extremes(all.particles(), all.contacts(), all.bonds()));
}

}  // namespace gyro
