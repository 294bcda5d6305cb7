// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace gyro {

/// Relays that switch the motor off, and the brake and restart that follow. A relay whose first value is 0 is absent.
struct ProtectionParameters {
  /// Inverse-time: thermal image h of the motor, overload_time dh/dt = (I/In)^2 - h, trips at h = overload_ratio^2
  /// (IEC 60255-149). A cold motor at current I trips after overload_time ln(I^2 / (I^2 - overload_ratio^2)).
  double overload_time = 0;        ///< [s]
  double overload_ratio = 1.05;    ///< largest current that does not trip / rated current [-]
  double instantaneous_ratio = 0;  ///< current that trips immediately / rated current [-]
  double under_speed = 0;          ///< limit / idle speed; armed once the speed has exceeded it [-]
  double under_speed_delay = 0;    ///< time below it before it trips [s]
  double rated_torque = 0;         ///< at the motor's shaft, for motors without a name plate [N m]
  double brake_torque = 0;         ///< dry, at the motor's shaft, from a trip to the restart; 0: it coasts [N m]
  double restart_delay = 0;        ///< from trip to restart; 0: it stays off [s]
  int restarts = 1;                ///< largest number of restarts
  bool restart_reversed = false;   ///< each restart reverses the rotation, to clear the chamber

  bool any() const { return overload_time > 0 || instantaneous_ratio > 0 || under_speed > 0; }
};

/// Events of a drive.
enum class DriveEventKind {
  stall = 1,           ///< came to a halt although the motor drove it
  turned_back,         ///< the rock drove it backward against the motor
  standstill,          ///< came to a halt with the motor off
  overload_trip,       ///< motor off: thermal image
  instantaneous_trip,  ///< motor off: current
  under_speed_trip,    ///< motor off: too slow for too long
  restart,             ///< motor on again, same sense
  reversed_restart,    ///< motor on again, other sense
  held,                ///< came to rest between rock and motor, after the rock had driven it backward
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
  double last_sense = 1;   ///< sense before the motor was switched off
  double heat = 0;         ///< thermal image h [-]
  double armed = 0;        ///< 1 once the speed has exceeded the under-speed limit
  double slow_since = -1;  ///< time at which the speed fell below the limit [s]; < 0: not below
  double restart_at = -1;  ///< time of the next restart [s]; < 0: none is due
  double restarts = 0;     ///< number so far

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

/// The relays: their limits as roots of the equation of motion, and their actions.
class Protection {
 public:
  enum Event { too_hot, too_much_current, crossed_slow, events };

  Protection(const ProtectionParameters& parameters, double idle_speed)
      : p_(parameters), slow_speed_(parameters.under_speed * idle_speed) {}

  bool watches_heat() const { return p_.overload_time > 0; }
  double heat_rate(double current, double heat) const { return (current * current - heat) / p_.overload_time; }
  double brake_torque(const SwitchState& state) const { return state.sense == 0 ? p_.brake_torque : 0; }

  /// Values whose roots end a leg, by Event; 1 for a relay that is absent. @param speed  of the eccentric [rad/s]
  void watch(const SwitchState& state, double current, double heat, double speed, std::span<double> values) const;
  /// Time of the next timed trip or restart, since the start of the run [s]; infinity if there is none.
  double next_deadline(const SwitchState& state) const;
  /// Performs the trips and restarts that are due, between two legs.
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
