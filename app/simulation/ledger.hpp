// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gyro {

/// Limits beyond which a run stops instead of going on with numbers that look right.
struct LedgerLimits {
  /// Hertz's law is long left at an overlap of 0.3, where the log warns.
  StepLimits step;
  /// Residual over the larger of the work done and the largest kinetic + elastic energy seen [-].
  double energy_fraction = 0.05;
  /// Step of the contacts, held ones included [s]. Their forces and the energies are up to one of it apart, so that the
  /// balance may also be off by `lag_steps` times the work of such a step: much of all work just after the first touch.
  double contact_step = 0;
  double lag_steps = 3;  ///< a force that grows as t^(3/2) does 5/2 of its mean work in the last step
};

/// Particles that came, went and are there.
struct MassCount {
  std::int64_t fed = 0, discharged = 0, inside = 0;
  std::int64_t residual() const { return fed - discharged - inside; }
};

/// How a verdict begins.
std::string stopped_at(double time, const std::string& why);

/// The running balance of a run: energy, particles, and what the guard looks at.
class Ledger {
 public:
  /// @param walls  names of the scene's walls, for messages
  explicit Ledger(LedgerLimits limits = {}, std::vector<std::string> walls = {})
      : limits_(limits), walls_(std::move(walls)) {}

  /// Takes up the state before the window's rock came and went, so that gravity's work is that of the
  /// DEM alone.
  void open(const EnergyTerms& before) { potential_before_ = before.potential; }
  /// Closes the window that ends at `time`.
  /// @return why the run must not go on, with the id of the particle; nothing while all is well
  std::optional<std::string> close(double time, const EnergyTerms& after, const Extremes& extremes);

  const EnergyTerms& energy() const { return energy_; }
  const Extremes& extremes() const { return extremes_; }
  double worst_overlap() const { return worst_overlap_; }  ///< largest overlap / radius at the end of any window
  double gravity_work() const { return gravity_work_; }    ///< [J]
  /// Residual over the work that walls and gravity have done; 0 before any work.
  double residual_fraction() const;

  void save(SavedState& to) const;
  void restore(const SavedState& from);

 private:
  double work() const;  ///< that walls and gravity have done or taken [J]
  std::string passed_limit() const;
  std::optional<std::string> verdict(double time) const;

  std::string wall_name(Index wall) const;

  LedgerLimits limits_;
  std::vector<std::string> walls_;
  EnergyTerms energy_;
  Extremes extremes_;
  double potential_before_ = 0, gravity_work_ = 0, gravity_turnover_ = 0, largest_state_ = 0, worst_overlap_ = 0;
  double time_ = 0, work_before_ = 0, power_ = 0;  ///< end of the last window; work until then; mean power in it
};

}  // namespace gyro
