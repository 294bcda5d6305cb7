// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"
#include "core/dem/dem_solver.hpp"

// One window and one step of the DEM.

namespace gyro {

template <class Exec, class Real>
void DemSolver<Exec, Real>::advance(const Window& window, const MantlePath& path) {
  if (window.steps % scene_.substeps != 0)
    throw BadInput("a window of " + std::to_string(window.steps) + " steps is no whole number of holds of " +
                   std::to_string(scene_.substeps) + " steps");
  place_walls(window, path);
  first_excess_.reset();
  if (!primed_) prime();
  const Index walls = surfaces_.count();
  for (int k = 1; k <= window.steps; ++k) {
    poses_ = pose_table_.data() + static_cast<std::ptrdiff_t>(k) * walls;
    poses_now_.assign(host_table_.begin() + static_cast<std::ptrdiff_t>(k) * walls,
                      host_table_.begin() + static_cast<std::ptrdiff_t>(k + 1) * walls);
    step(window.first_step + k, (k - 1) % scene_.substeps == 0, k + scene_.substeps > window.steps);
  }
  poses_now_ = end_poses_;
  close_window(window);
}

/// Velocity Verlet; forces that depend on velocity see v(n+1/2), all others x(n+1). With scene.hold = k > 1
/// contacts and walls are evaluated in every k-th step, for the places in the middle of the k steps.
/// @param fresh    the first step of a hold
/// @param closing  in the last hold of a window
template <class Exec, class Real>
void DemSolver<Exec, Real>::step(std::int64_t number, bool first_of_hold, bool closing) {
  move();
  if (first_of_hold) {
    const Host<std::int32_t> flags = Exec::host(flags_);
    if (flags[3] != 0 && !first_excess_) first_excess_ = extremes_now(true);
    if (neighbours_stale(flags)) rebuild_lists();
  }
  if (has_bonds()) bond_forces(number);
  if (first_of_hold) contact_forces(half_hold_offset(), closing ? carry_over_fraction() : 0);
  gather(first_of_hold, true);
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::move() {
  exec_.for_each("move", particle_count(),
                 Move{view(), scene_.dt, half_hold_offset(), 0.25 * skin_ * skin_, flags_.data(), has_bonds(),
                      hold_time(), scene_.limits, flags_.data() + 3});
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::bond_forces(std::int64_t number) {
  const BreakLog log{events_.data(), flags_.data() + 2,           flags_.data() + 1,
                     blocks_.data(), scene_.limits.bond_rotation, flags_.data() + 3};
  exec_.for_each_block("bond forces", block_list(), BondForces<Real>{view(), bond_view(), bond_law(), log, number});
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::contact_forces(double half_hold_offset, double carry_over) {
  scene_.substeps == 1 ? launch_contacts<false>(half_hold_offset, carry_over)
                       : launch_contacts<true>(half_hold_offset, carry_over);
}

template <class Exec, class Real>
template <bool held>
void DemSolver<Exec, Real>::launch_contacts(double half_hold_offset, double carry_over) {
  const PairView<Real> pairs = pair_view(pairs_);
  const WallView<Real> walls = wall_view(walls_);
  const std::int32_t* bond_state = has_bonds() ? bonds_.state.data() : nullptr;
  const OverlapCheck deep{scene_.limits.overlap_ratio, flags_.data() + 3};
  with_contact_law(rock_model_, [&]<class Law>(Law) {
    exec_.for_each("pair forces", pairs.count,
                   PairForces<Real, Law, held>{view(), pairs, bond_state, rock_law_, half_hold_offset, deep});
  });
  with_contact_law(wall_model_, [&]<class Law>(Law) {
    exec_.for_each(
        "wall forces", walls.count,
        WallForces<Real, Law, held>{view(), walls, wall_laws_.data(), hold_time(), half_hold_offset, carry_over, deep});
  });
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::gather(bool first_of_hold, bool kick) {
  if (scene_.substeps > 1) held_.resize(static_cast<std::size_t>(particle_count()));
  Load* held = scene_.substeps > 1 ? held_.data() : nullptr;
  exec_.for_each("gather", particle_count(),
                 Gather<Real>{view(), pair_view(pairs_), wall_view(walls_), scene_.gravity, scene_.dt, has_bonds(),
                              held, first_of_hold, kick});
}

/// Loads at the very start, so that the first half kick is a real one.
template <class Exec, class Real>
void DemSolver<Exec, Real>::prime() {
  primed_ = true;
  rebuild_lists();
  booked_.exchanged += bond_sums().elastic;  // before any bond fails
  if (has_bonds()) bond_forces(0);
  contact_forces(0, carry_over_fraction());
  gather(true, false);
  book_walls();
  kept_impulses_.clear();
  carry_over_walls();  // in place of the sums: no time has passed, nothing was done
  booked_.exchanged += contact_sums().elastic;
}

/// Poses of all walls for each step of the window, so that nothing is asked of the host inside it: row k is
/// what contacts see in step k, the middle of the hold that begins with it.
template <class Exec, class Real>
void DemSolver<Exec, Real>::place_walls(const Window& window, const MantlePath& path) {
  const std::size_t count = scene_.walls.size();
  host_table_.resize(count * static_cast<std::size_t>(window.steps + 1));
  const auto pose_after = [&](double k, std::size_t w) {
    return pose_of(scene_.walls[w], (static_cast<double>(window.first_step) + k) * window.dt,
                   mantle_at(path, k * window.dt));
  };
  const double middle = 0.5 * (scene_.substeps - 1);
  for (int k = 0; k <= window.steps; ++k)
    for (std::size_t w = 0; w < count; ++w)
      host_table_[static_cast<std::size_t>(k) * count + w] = pose_after(k == 0 ? 0 : k + middle, w);
  end_poses_.resize(count);
  for (std::size_t w = 0; w < count; ++w) end_poses_[w] = pose_after(window.steps, w);
  wall_step_ = 0;
  for (std::size_t w = 0; w < count; ++w) {  // a motion's speed changes from window to window only
    const double way = hold_time() * sweep_speed(scene_.walls[w], surfaces_.extent(w), host_table_[w]);
    if (way > wall_step_) wall_step_ = way, fast_wall_ = static_cast<Index>(w);
  }
  Exec::upload(pose_table_, host_table_);
  poses_ = pose_table_.data();
  poses_now_.assign(host_table_.begin(), host_table_.begin() + static_cast<std::ptrdiff_t>(count));
}

/// Whether a particle or a wall has gone further than half the margin, or a rock has just cracked.
template <class Exec, class Real>
bool DemSolver<Exec, Real>::neighbours_stale(const Host<std::int32_t>& flags) const {
  if (!listed_ || flags[0] != 0 || flags[1] != 0) return true;
  for (std::size_t w = 0; w < poses_now_.size(); ++w) {
    const WallPose &a = listed_poses_[w], &b = poses_now_[w];
    const Quatd rotated = b.orientation * conjugate(a.orientation);
    const double angle = 2 * norm(Vec3d{rotated.x, rotated.y, rotated.z});
    const double way = norm(b.origin - a.origin) + (angle > 0 ? surfaces_.extent(w) * 1.6 * angle : 0.0);
    if (way > 0.5 * skin_) return true;
  }
  return false;
}

template <class Exec, class Real>
void DemSolver<Exec, Real>::close_window(const Window& window) {
  book_walls();
  note_impulses();
  for (std::size_t w = 0; w < wall_sums_.size(); ++w) {
    const WallSum& s = wall_sums_[w];
    const double mean = wall_quantum / window.length();
    wall_loads_[w].force = mean * Vec3d{double(s.force[0]), double(s.force[1]), double(s.force[2])};
    wall_loads_[w].torque = mean * Vec3d{double(s.torque[0]), double(s.torque[1]), double(s.torque[2])};
    wall_loads_[w].work = wall_quantum * static_cast<double>(s.work);
    booked_.wall_work += wall_loads_[w].work;
  }
  carry_over_walls();
  counts_total_.particle_steps += std::int64_t{particle_count()} * (window.steps / scene_.substeps);
  counts_total_.bond_steps += counts_total_.bonds_intact * window.steps;
  drain_breakages(window);
  record_excess();
}

/// Keeps what passed a limit in the last step, and lowers the flag.
template <class Exec, class Real>
void DemSolver<Exec, Real>::record_excess() {
  Host<std::int32_t> flags = Exec::host(flags_);
  if (flags[3] == 0) return;
  if (!first_excess_) first_excess_ = extremes_now(true);
  flags[3] = 0;
  Exec::upload(flags_, std::move(flags));
}

}  // namespace gyro
