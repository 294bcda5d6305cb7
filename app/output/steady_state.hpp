// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace gyro {

/// Means over one gyration.
struct GyrationMeans {
  double begin = 0, end = 0;  ///< [s]
  double power = 0;           ///< crushing [W]
  double holdup = 0;          ///< [kg]
  double discharged = 0;      ///< in this gyration [kg]

  template <class F, class... G>
  static constexpr void for_each_field(F&& f, G&... g) {
    f("begin", g.begin...);
    f("end", g.end...);
    f("power", g.power...);
    f("holdup", g.holdup...);
    f("discharged", g.discharged...);
  }
};
static_assert(declares_every_field<GyrationMeans>);

/// What a crusher shows while it runs as it did before.
struct SteadyState {
  double from = 0;                       ///< [s]
  double power = 0;                      ///< mean since then [W]
  double throughput = 0;                 ///< [kg/s]
  std::optional<double> residence_time;  ///< mean hold-up / throughput (Little's law) [s]; none without discharge
};

/// When a drift counts as none.
struct SteadyLimits {
  std::size_t min_gyrations = 10;
  double holdup_drift = 0.05;  ///< of its fitted line over the time looked at / mean [-]
  double power_change = 0.05;  ///< between the two halves of that time / mean [-]
};

/// The earliest gyration from which on, to the end of the run, hold-up and power have no drift: the line fitted
/// to hold-up changes by less than holdup_drift of its mean, and the mean powers of both halves differ by less than
/// power_change or two standard errors. None when there is no such gyration, or too few follow it: the run was
/// not long enough to say so. A chamber that fills slower than this shows passes: look at the hold-up.
std::optional<SteadyState> steady_state(const std::vector<GyrationMeans>& gyrations, const SteadyLimits& limits = {});

/// Collects windows to whole gyrations, by the angle of the eccentric.
class GyrationReader {
 public:
  /// @param angle  of the eccentric at the window's end [rad]
  void add(double time, double length, double angle, double power, double holdup, double discharged_so_far);
  const std::vector<GyrationMeans>& gyrations() const { return state_.done; }

  void save(SavedState& to) const { to.put_one("gyrations", state_); }
  void restore(const SavedState& from) { state_ = from.get_one<State>("gyrations"); }

 private:
  struct State {
    std::vector<GyrationMeans> done;
    double begin = 0;              ///< of the present gyration [s]
    double length = 0;             ///< of its windows so far [s]
    double power = 0, holdup = 0;  ///< sums of value x window length in it [J], [kg s]
    double turns = 0;              ///< whole turns at its begin
    double discharged = 0;         ///< mass discharged by its begin [kg]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("done", s.done...);
      f("begin", s.begin...);
      f("length", s.length...);
      f("power", s.power...);
      f("holdup", s.holdup...);
      f("turns", s.turns...);
      f("discharged", s.discharged...);
    }
  };
  State state_;
};

}  // namespace gyro
