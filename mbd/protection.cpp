// SPDX-License-Identifier: GPL-3.0-or-later
#include "mbd/protection.hpp"

#include <algorithm>
#include <limits>

namespace gyro {
namespace {

/// Whether a deadline has come, up to the rounding of sums of leg durations.
bool reached(double now, double deadline) {
  return now >= deadline - 1e-12 * std::max(1.0, deadline);
}

}  // namespace

std::string to_string(DriveEventKind kind) {
  switch (kind) {
    case DriveEventKind::stall:
      return "stall";
    case DriveEventKind::turned_back:
      return "turned back by the rock";
    case DriveEventKind::standstill:
      return "standstill";
    case DriveEventKind::overload_trip:
      return "overload trip";
    case DriveEventKind::instantaneous_trip:
      return "instantaneous trip";
    case DriveEventKind::under_speed_trip:
      return "under-speed trip";
    case DriveEventKind::restart:
      return "restart";
    case DriveEventKind::reversed_restart:
      return "reversed restart";
    case DriveEventKind::held:
      return "held at rest";
    case DriveEventKind::trip:
      return "trip";
  }
  return "unknown";
}

void Protection::watch(const SwitchState& state, double current, double heat, double speed,
                       std::span<double> values) const {
  const bool on = state.sense != 0;
  values[too_hot] = on && p_.overload_time > 0 ? heat_limit() - heat : 1;
  values[too_much_current] = on && p_.instantaneous_ratio > 0 ? p_.instantaneous_ratio - current : 1;
  values[crossed_slow] = on && p_.under_speed > 0 ? state.sense * speed - slow_speed_ : 1;
}

double Protection::next_deadline(const SwitchState& state) const {
  double next = std::numeric_limits<double>::infinity();
  if (state.sense != 0 && state.slow_since >= 0) next = state.slow_since + p_.under_speed_delay;
  if (state.sense == 0 && state.restart_at >= 0) next = state.restart_at;
  return next;
}

/// The speed crosses the threshold of the relay alternately upwards and downwards.
void Protection::follow_speed(SwitchState& state, double now, double speed, bool crossed) const {
  if (!(p_.under_speed > 0)) return;
  const bool fast = state.sense * speed > slow_speed_;
  if (state.armed == 0) {
    if (crossed || fast) state.armed = 1;
  } else if (crossed) {
    state.slow_since = state.slow_since < 0 ? now : -1;
  } else if (fast) {
    state.slow_since = -1;
  } else if (state.slow_since < 0) {
    state.slow_since = now;
  }
}

std::optional<DriveEventKind> Protection::trip_due(const SwitchState& state, double now, double current,
                                                   const std::array<bool, events>& fired) const {
  if (p_.overload_time > 0 && (fired[too_hot] || state.heat >= heat_limit())) return DriveEventKind::overload_trip;
  if (p_.instantaneous_ratio > 0 && (fired[too_much_current] || current >= p_.instantaneous_ratio))
    return DriveEventKind::instantaneous_trip;
  if (state.slow_since >= 0 && reached(now, state.slow_since + p_.under_speed_delay))
    return DriveEventKind::under_speed_trip;
  return {};
}

void Protection::settle(SwitchState& state, double now, double current, double speed,
                        const std::array<bool, events>& fired, std::vector<DriveEvent>& happened) const {
  if (!p_.any()) return;
  if (state.sense == 0 && state.restart_at >= 0 && reached(now, state.restart_at)) {
    state.sense = p_.restart_reversed ? -state.last_sense : state.last_sense;
    happened.push_back({now, p_.restart_reversed ? DriveEventKind::reversed_restart : DriveEventKind::restart});
    state.restart_at = -1;
    ++state.restarts;
    return;  // the next call checks the current of the motor, which is on now
  }
  if (state.sense == 0) return;
  follow_speed(state, now, speed, fired[crossed_slow]);
  const std::optional<DriveEventKind> trip = trip_due(state, now, current, fired);
  if (!trip) return;
  happened.push_back({now, *trip});
  state.last_sense = state.sense;
  state.sense = state.armed = 0;
  state.slow_since = -1;
  if (p_.restart_delay > 0 && state.restarts < p_.restarts) state.restart_at = now + p_.restart_delay;
}

}  // namespace gyro
