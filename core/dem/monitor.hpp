// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/dem/particle_store.hpp"
#include "core/kernels/bond_forces.hpp"
#include "core/scene/accounts.hpp"
#include "core/state/step_flags.hpp"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace gyro {

/// The larger of both in every respect.
inline Extremes worst_of(const Extremes& a, const Extremes& b) {
  Extremes x = a;
  const bool other_overlap = x.finite && (!b.finite || b.overlap_ratio > a.overlap_ratio);
  if (other_overlap) x.culprit = b.culprit, x.partner = b.partner, x.wall = b.wall;
  x.finite = a.finite && b.finite;
  x.overlap_ratio = larger(a.overlap_ratio, b.overlap_ratio);
  if (b.speed_ratio > a.speed_ratio) x.speed_ratio = b.speed_ratio, x.fastest = b.fastest;
  if (b.rotation > a.rotation) x.rotation = b.rotation, x.fastest_rotating = b.fastest_rotating;
  if (b.contact_step > a.contact_step) x.contact_step = b.contact_step, x.crowded = b.crowded, x.crowd = b.crowd;
  if (b.bond_rotation > a.bond_rotation) x.bond_rotation = b.bond_rotation, x.twisted = b.twisted;
  return x;
}

/// Owns what is known of a run beside its state: the flags that kernels raise, the extremes of the first step of a
/// window that passed a limit, the bonds that failed, and counts and energies since the start.
template <class Exec>
class Monitor {
 public:
  Monitor() { lower_all(); }

  /// On the executor, until a flag is lowered.
  StepFlags* flags() { return flags_.data(); }
  /// @param steps  as BreakLog::steps
  BreakLog break_log(double rotation_limit, const std::int32_t* steps) {
    StepFlags* f = flags();
    return {events_.data(), &f->failures, &f->block_cracked, rotation_limit, &f->limit_exceeded, steps};
  }
  StepFlags raised() const { return Exec::host(flags_)[0]; }

  /// Room for the failures of a window: each bond fails once.
  void reserve_events(Index bonds) { events_.resize(static_cast<std::size_t>(bonds)); }

  void begin_window() { first_excess_.reset(); }
  bool has_excess() const { return first_excess_.has_value(); }
  /// Extremes of the first step of the window that passed a limit.
  void keep_excess(const Extremes& extremes) { first_excess_ = extremes; }
  /// @param now  extremes of the present state
  Extremes worst(const Extremes& now) const { return first_excess_ ? worst_of(now, *first_excess_) : now; }
  void lower_limit_flag() {
    StepFlags flags = raised();
    flags.limit_exceeded = 0;
    set(flags);
  }

  void rocks_freed() {
    StepFlags flags = raised();
    flags.rock_overloaded = 0;
    set(flags);
  }
  /// @param overloaded  a rock must be bonded because no rows can be made for it
  void rows_made(bool overloaded) {
    StepFlags flags = raised();
    flags.rows_lacking = 0;
    if (overloaded) flags.rock_overloaded = 1;
    set(flags);
  }
  void pairs_renewed() {
    StepFlags flags = raised();
    flags.moved_too_far = 0;
    set(flags);
  }
  void lists_rebuilt() {
    StepFlags flags = raised();
    flags.moved_too_far = flags.block_cracked = 0;
    set(flags);
    ++counts_.rebuilds;
  }

  /// Brings the failures of the window into order and books the energy that they released.
  template <class Real>
  void collect_breakages(const ParticleStore<Exec, Real>& rock, double dt) {
    StepFlags flags = raised();
    if (flags.failures == 0) return;
    const std::vector<Breakage> failed = breakages(rock, static_cast<std::size_t>(flags.failures), dt);
    for (const Breakage& b : failed) {
      energies_.bond_breakage += b.energy;
      ++(b.mode == BreakMode::tension ? counts_.broken_tension : counts_.broken_shear);
    }
    counts_.bonds_intact -= flags.failures;
    breakages_.insert(breakages_.end(), failed.begin(), failed.end());
    flags.failures = 0;
    set(flags);
  }
  std::vector<Breakage> take_breakages() { return std::exchange(breakages_, {}); }

  /// Energies that have been booked: of what has left, of failures and of walls; the states are zero.
  EnergyTerms& energies() { return energies_; }
  const EnergyTerms& energies() const { return energies_; }
  /// Books what particles that leave have lost.
  void book_losses(const std::vector<LostWork>& losses, const Remaining& remaining) {
    for (std::size_t n = 0; n < losses.size(); ++n) {
      if (remaining.new_index[n] != none) continue;
      const LostWork& lost = losses[n];
      energies_.bond_damping += lost.bond_damping;
      energies_.contact_damping += lost.contact_damping;
      energies_.friction += lost.bond_slip + lost.contact_slip;
    }
  }

  /// All but the number of particles, which is that of the store.
  Counts& counts() { return counts_; }
  const Counts& counts() const { return counts_; }
  /// Intact bonds, each as often as its rock has sub-steps.
  std::int64_t bonds_in_step() const { return bonds_in_step_; }
  void add_bonds_in_step(std::int64_t more) { bonds_in_step_ += more; }

  void save(SavedState& to) const {
    to.put_one("dem/energies", energies_);
    to.put_one("dem/counts", counts_);
    to.put_one("dem/bonds_in_step", bonds_in_step_);
    to.put("dem/breakages", breakages_);
  }
  /// @throws BadInput as SavedState::get
  void restore(const SavedState& from) {
    energies_ = from.get_one<EnergyTerms>("dem/energies");
    counts_ = from.get_one<Counts>("dem/counts");
    bonds_in_step_ = from.get_one<std::int64_t>("dem/bonds_in_step");
    breakages_ = from.get<Breakage>("dem/breakages");
    first_excess_.reset();
    lower_all();
  }

 private:
  void set(const StepFlags& flags) { Exec::upload(flags_, std::vector<StepFlags>{flags}); }
  void lower_all() { set(StepFlags{}); }

  /// The bonds that have failed, ordered by time, i, j.
  template <class Real>
  std::vector<Breakage> breakages(const ParticleStore<Exec, Real>& rock, std::size_t count, double dt) {
    const auto& events = Exec::host(events_);
    const auto& bond_i = Exec::host(rock.bonds().i);
    const auto& bond_j = Exec::host(rock.bonds().j);
    const auto& position = Exec::host(rock.particles().position);
    const auto& id = Exec::host(rock.particles().id);
    const auto& block = Exec::host(rock.particles().block);
    const auto& blocks = Exec::host(rock.blocks());
    std::vector<Breakage> failed;
    for (std::size_t k = 0; k < count; ++k) {
      const BreakEvent& e = events[k];
      const auto i = static_cast<std::size_t>(bond_i[static_cast<std::size_t>(e.bond)]),
                 j = static_cast<std::size_t>(bond_j[static_cast<std::size_t>(e.bond)]);
      const Vec3d middle = 0.5 * (position[i].x + position[j].x);
      const Block& own = blocks[static_cast<std::size_t>(block[i])];
      const double steps = static_cast<double>(e.step) + (e.substep + 1.0) / own.substeps;
      failed.push_back({steps * dt, static_cast<BreakMode>(e.mode), middle, own.rock, id[i], id[j], e.energy});
      bonds_in_step_ -= own.substeps;
    }
    std::sort(failed.begin(), failed.end(), [](const Breakage& a, const Breakage& b) {
      return std::tie(a.time, a.i, a.j) < std::tie(b.time, b.i, b.j);
    });
    return failed;
  }

  typename Exec::template Buffer<StepFlags> flags_;     ///< one
  typename Exec::template Scratch<BreakEvent> events_;  ///< of this window, StepFlags::failures of them
  std::optional<Extremes> first_excess_;
  std::vector<Breakage> breakages_;  ///< since they were last taken
  EnergyTerms energies_;
  Counts counts_;
  std::int64_t bonds_in_step_ = 0;
};

}  // namespace gyro
