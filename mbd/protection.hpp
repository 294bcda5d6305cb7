// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Relays that switch the motor off, and what happens then. A relay whose first value is 0 does not exist.
struct ProtectionParameters {
  /// Inverse-time: thermal image h of the motor, overload_time dh/dt = (I/In)^2 - h, trips at h = overload_ratio^2
  /// (IEC 60255-149). A cold motor at current I trips after overload_time ln(I^2 / (I^2 - overload_ratio^2)).
  double overload_time = 0;        ///< [s]
  double overload_ratio = 1.05;    ///< current that never trips / rated current [-]
  double instantaneous_ratio = 0;  ///< current that trips at once / rated current [-]
  double under_speed = 0;          ///< share of the idle speed; armed once it has been exceeded [-]
  double under_speed_delay = 0;    ///< time below it before it trips [s]
  double rated_torque = 0;         ///< at the motor, for motors without a name plate [N m]
  double brake_torque = 0;         ///< dry, at the motor's shaft, from a trip to the restart; 0: it coasts [N m]
  double restart_delay = 0;        ///< from trip to restart; 0: it stays off [s]
  int restarts = 1;                ///< at most
  bool restart_reversed = false;   ///< restarts change the sense of rotation, to clear the chamber

  bool any() const { return overload_time > 0 || instantaneous_ratio > 0 || under_speed > 0; }
};

/// Events of a drive.
enum class DriveEventKind {
  stall = 1,           ///< came to a halt although the motor drove it
  turned_back,         ///< the rock turned it against its motor
  standstill,          ///< came to a halt with the motor off
  overload_trip,       ///< motor off: thermal image
  instantaneous_trip,  ///< motor off: current
  under_speed_trip,    ///< motor off: too slow for too long
  restart,             ///< motor on again, same sense
  reversed_restart,    ///< motor on again, other sense
  held,                ///< at rest between rock and motor, after the rock had turned it back
  trip                 ///< motor off, for a reason that an FMU does not give
};

struct DriveEvent {
  double time;  ///< since the start of the run [s]
  DriveEventKind kind;
};

/// "overload trip", for logs and summaries.
std::string to_string(DriveEventKind kind);

/// State of motor switch and relays.
struct SwitchState {
  double sense = 1;        ///< +1 drives forward, -1 backward, 0 off
  double last_sense = 1;   ///< the one before it was switched off
  double heat = 0;         ///< thermal image h [-]
  double armed = 0;        ///< 1 once the under-speed relay has seen its speed
  double slow_since = -1;  ///< [s]; < 0: not slow
  double restart_at = -1;  ///< [s]; < 0: no restart is due
  double restarts = 0;     ///< so far

  /// Calls f(name, field) for every field, to be read or filled.
  template <class F, class S>
  static constexpr void for_each_field(F&& f, S& s) {
    f("sense", s.sense);
    f("last_sense", s.last_sense);
    f("heat", s.heat);
    f("armed", s.armed);
    f("slow_since", s.slow_since);
    f("restart_at", s.restart_at);
    f("restarts", s.restarts);
  }
};

/// The relays: their limits as roots of the equation of motion, and what they do.
class Protection {
 public:
  enum Event { too_hot, too_much_current, crossed_slow, events };

  Protection(const ProtectionParameters& parameters, double idle_speed)
      : p_(parameters), slow_speed_(parameters.under_speed * idle_speed) {}

  bool watches_heat() const { return p_.overload_time > 0; }
  double heat_rate(double current, double heat) const { return (current * current - heat) / p_.overload_time; }
  double brake_torque(const SwitchState& state) const { return state.sense == 0 ? p_.brake_torque : 0; }

  /// Values whose roots end a leg; 1 where a relay does not watch. @param speed  of the eccentric [rad/s]
  void watch(const SwitchState& state, double current, double heat, double speed, std::span<double> values) const;
  /// The next time at which the switch acts by the clock, or infinity [s].
  double next_deadline(const SwitchState& state) const;
  /// Switches what is due, between two legs.
  /// @param fired  which Event has ended the last leg; all false at the start of an interval
  void settle(SwitchState& state, double now, double current, double speed, const std::array<bool, events>& fired,
              std::vector<DriveEvent>& happened) const;

 private:
  double heat_limit() const { return p_.overload_ratio * p_.overload_ratio; }
  void follow_speed(SwitchState& state, double now, double speed, bool crossed) const;
  std::optional<DriveEventKind> trip_due(const SwitchState& state, double now, double current,
                                         const std::array<bool, events>& fired) const;

  ProtectionParameters p_;
  double slow_speed_;  ///< [rad/s]
};

}  // namespace gyro
