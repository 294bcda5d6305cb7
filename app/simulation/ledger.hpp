// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/accounts.hpp"
#include "core/scene/scene.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// Limits beyond which a run stops instead of continuing with numbers that only look right.
struct LedgerLimits {
  /// Of a single step. (Hertz's law no longer holds at an overlap ratio of 0.3, where the log warns.)
  StepLimits step;
  /// Of the residual over Ledger::scale() [-].
  double energy_fraction = 0.05;
  /// Step of the contacts, a whole hold where forces are held [s]. Forces and energies may be one such step apart, so
  /// the balance may also be off by `lag_steps` times the work of one step: much of all work just after the first
  /// contact.
  double contact_step = 0;
  double lag_steps = 3;  ///< a force that grows as t^(3/2) does 5/2 of its mean work in the last step
};

/// Particles that were inserted, that were discharged, that escaped over the rim, and that are in the chamber.
struct MassCount {
  std::int64_t fed = 0, discharged = 0, escaped = 0, inside = 0;
  std::int64_t residual() const { return fed - discharged - escaped - inside; }
};

/// The text of a verdict.
std::string stopped_at(double time, const std::string& why);

/// The energy balance of a run, and its guard. With E the kinetic, potential and elastic energies, L the losses
/// (contact damping, friction, bond damping, energy of broken bonds), W the work of the walls and X the energy of
/// inserted less removed rock, all since the start [J],
///
///   residual = E + L - W - X,   zero up to rounding and the error of the time integration.
///
/// The run must stop when |residual| exceeds energy_fraction of the scale, the larger of the work done by walls and
/// gravity and of the largest kinetic + elastic energy so far, or when a step passes one of the step's limits.
class Ledger {
 public:
  /// What a checkpoint keeps.
  struct State {
    EnergyTerms energy;
    double overlap_ratio = 0;                           ///< at the end of the last window [-]
    double worst_overlap = 0;                           ///< of all windows [-]
    double potential_before = 0, gravity_turnover = 0;  ///< [J]
    double largest_state = 0;                           ///< kinetic + elastic energy so far [J]
    double time = 0, work_before = 0;                   ///< end of the last window [s], work until then [J]

    /// Calls f(name, field) for every field, to be read or filled.
    template <class F, class S>
    static constexpr void for_each_field(F&& f, S& s) {
      f("energy", s.energy);
      f("overlap_ratio", s.overlap_ratio);
      f("worst_overlap", s.worst_overlap);
      f("potential_before", s.potential_before);
      f("gravity_turnover", s.gravity_turnover);
      f("largest_state", s.largest_state);
      f("time", s.time);
      f("work_before", s.work_before);
    }
  };

  /// @param walls  names of the scene's walls, for messages
  explicit Ledger(LedgerLimits limits = {}, std::vector<std::string> walls = {})
      : limits_(limits), walls_(std::move(walls)) {}

  /// Notes the state after rock was inserted or removed, so that gravity's work is that of the DEM alone.
  void open(const EnergyTerms& before);
  /// Closes the window that ends at `time` [s].
  /// @return why the run must stop, with the id of the particle; nothing while all is well
  std::optional<std::string> close(double time, const EnergyTerms& after, const Extremes& extremes);

  const EnergyTerms& energy() const { return state_.energy; }
  const Extremes& extremes() const { return extremes_; }         ///< of the last window
  double worst_overlap() const { return state_.worst_overlap; }  ///< largest overlap / radius at any window's end
  /// What a residual is measured by: the larger of the work that walls and gravity have done or taken, each counted
  /// positive, and of the largest kinetic + elastic energy since the start [J].
  double scale() const;
  /// Residual / scale, with its sign; 0 where there has been neither work nor energy.
  double residual_fraction() const;

  const State& state() const { return state_; }
  void restore(const State& state);

 private:
  void note_energy(const EnergyTerms& now);
  double work() const;  ///< that walls and gravity have done or taken [J]
  std::string passed_limit() const;
  std::optional<std::string> verdict(double time) const;

  std::string wall_name(Index wall) const;

  LedgerLimits limits_;
  std::vector<std::string> walls_;
  State state_;
  Extremes extremes_;
  double power_ = 0;  ///< mean in the last window [W]
};

}  // namespace gyro
