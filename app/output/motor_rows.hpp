// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "io/run/summary.hpp"

#include <optional>
#include <vector>

namespace gyro {

/// The motor's power by rows of /series, for the summary.
class MotorRows {
 public:
  /// Adds a coupling window to the present row. @param power  mean [W]
  void add(double length, double power);
  /// Ends the row at `time` [s].
  void end_row(double time);

  /// Mean, 95th percentile and peak of the rows that begin at `from` [s] or later. None without such a row.
  /// @param rated_power  of the motor [W]; none if it has no name plate
  std::optional<MotorFigures> figures(double from, std::optional<double> rated_power) const;

  void save(SavedState& to) const { to.put_one("output/motor", state_); }
  void restore(const SavedState& from) { state_ = from.get_one<State>("output/motor"); }

 private:
  struct State {
    std::vector<double> end, power;  ///< of the rows [s], mean [W]
    double length = 0, work = 0;     ///< of the present row [s], [J]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("end", s.end...);
      f("power", s.power...);
      f("length", s.length...);
      f("work", s.work...);
    }
  };
  State state_;
};

}  // namespace gyro
