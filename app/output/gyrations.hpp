// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"

#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Means over one gyration.
struct GyrationMeans {
  double begin = 0, end = 0;  ///< [s]
  double power = 0;           ///< crushing [W]
  double holdup = 0;          ///< [kg]
  double discharged = 0;      ///< in this gyration [kg]
  double motor_power = 0;     ///< [W]

  template <class F, class... G>
  static constexpr void for_each_field(F&& f, G&... g) {
    f("begin", g.begin...);
    f("end", g.end...);
    f("power", g.power...);
    f("holdup", g.holdup...);
    f("discharged", g.discharged...);
    f("motor_power", g.motor_power...);
  }
};
static_assert(declares_every_field<GyrationMeans>);

/// The whole gyrations of a run.
struct GyrationRecord {
  std::vector<GyrationMeans> gyrations;
  /// Mass discharged in each gyration by sieve, one gyration after the other, as Product::State::sieve_mass [kg].
  std::vector<double> sieve_mass = {};

  template <class F, class... R>
  static constexpr void for_each_field(F&& f, R&... r) {
    f("gyrations", r.gyrations...);
    f("sieve_mass", r.sieve_mass...);
  }
};

/// Quantities of a coupling window that gyrations need.
struct GyrationWindow {
  double time = 0, length = 0;              ///< end and length [s]
  double angle = 0;                         ///< of the eccentric at the end [rad]
  double power = 0, motor_power = 0;        ///< means [W]
  double holdup = 0;                        ///< at the end [kg]
  double discharged = 0;                    ///< since the start [kg]
  std::span<const double> sieve_mass = {};  ///< discharged since the start by sieve [kg]
};

/// Collects windows into whole gyrations, by the angle of the eccentric.
class GyrationReader {
 public:
  void add(const GyrationWindow& window);
  const GyrationRecord& record() const { return state_.done; }

  void save(SavedState& to, const std::string& name = "gyrations") const { to.put_one(name, state_); }
  void restore(const SavedState& from, const std::string& name = "gyrations") { state_ = from.get_one<State>(name); }

 private:
  struct State {
    GyrationRecord done;
    double begin = 0;                               ///< of the present gyration [s]
    double length = 0;                              ///< of its windows so far [s]
    double power = 0, motor_power = 0, holdup = 0;  ///< sums of value x window length in it [J], [kg s]
    double turns = 0;                               ///< whole revolutions at its beginning
    double discharged = 0;                          ///< mass discharged by its begin [kg]
    std::vector<double> sieve_mass;                 ///< the same by sieve [kg]

    template <class F, class... S>
    static constexpr void for_each_field(F&& f, S&... s) {
      f("done", s.done...);
      f("begin", s.begin...);
      f("length", s.length...);
      f("power", s.power...);
      f("motor_power", s.motor_power...);
      f("holdup", s.holdup...);
      f("turns", s.turns...);
      f("discharged", s.discharged...);
      f("sieve_mass", s.sieve_mass...);
    }
  };
  State state_;
};

}  // namespace gyro
