// SPDX-License-Identifier: GPL-3.0-or-later
// Relays, brake and restart, voltage, and the coupling spring.
#include "app/verify/fixtures/drives.hpp"
#include "core/base/errors.hpp"
#include "mbd/shaft.hpp"
#include "tests/catch.hpp"

namespace gyro {
namespace {

using namespace fixtures;

using enum DriveEventKind;

/// Droop machine without losses: J dw/dt = T0 (1 - w/ws) - L at the eccentric.
DrivetrainParameters droop_machine() {
  return {.motor = DroopMotor{.synchronous_speed = 20, .stall_torque = 50e3}, .eccentric_inertia = 4000};
}
constexpr double tau = 4000.0 * 20 / 50e3;  // [s]

/// Time at which the droop machine reaches w under a load L, from its idle speed.
double time_to(double speed, double load) {
  const double end = 20 * (1 - load / 50e3);
  return tau * std::log((20 - end) / (speed - end));
}

std::vector<DriveEvent> events_of(const DrivetrainParameters& machine, double load, double end, int windows) {
  Drivetrain drivetrain(machine);
  run(drivetrain, end, windows, [&](double, double) { return load; });
  return drivetrain.events();
}

}  // namespace

TEST_CASE("Overload relay: time of a cold motor at constant current", "[mbd][protection]") {
  DrivetrainParameters machine = droop_machine();
  machine.start = DrivetrainStart::rest;
  machine.eccentric_inertia = 1e12;  // does not move, so the current is constant
  const double current = GENERATE(2.0, 6.0);
  machine.protection = {.overload_time = 30, .rated_torque = 50e3 / current};
  const auto events = events_of(machine, 0, 20, GENERATE(1, 3, 500));
  REQUIRE(events.size() == 1);
  CHECK(events[0].kind == overload_trip);
  CHECK(events[0].time == Approx(30 * std::log(current * current / (current * current - 1.05 * 1.05))).epsilon(1e-7));
}

TEST_CASE("Instantaneous relay trips where the current reaches its limit", "[mbd][protection]") {
  DrivetrainParameters machine = droop_machine();
  machine.protection = {.instantaneous_ratio = 2, .rated_torque = 10e3};  // at 20 kN m, 12 rad/s
  const int windows = GENERATE(1, 10, 1000);
  const auto events = events_of(machine, 30e3, 2, windows);
  REQUIRE(events.size() >= 1);
  CHECK(events[0].kind == instantaneous_trip);
  CHECK(events[0].time == Approx(time_to(12, 30e3)).epsilon(1e-8));
}

TEST_CASE("Under-speed relay: armed by speed, trips after its delay", "[mbd][protection]") {
  DrivetrainParameters machine = droop_machine();
  machine.protection = {.under_speed = 0.5, .under_speed_delay = 0.3};
  const auto start = GENERATE(DrivetrainStart::running, DrivetrainStart::rest);
  machine.start = start;
  const double overload = 60e3;
  const int windows = GENERATE(40, 4000);
  const double length = 40.0 / windows, begin = start == DrivetrainStart::rest ? 32 : 0;  // 20 time constants
  Drivetrain drivetrain(machine);
  for (int k = 0; k < windows; ++k) {
    const bool loaded = k * length >= begin * (1 - 1e-12);
    exchange(drivetrain, window_number(k, length), [&](double, double) { return loaded ? overload : 0; });
    if (!loaded) REQUIRE(drivetrain.events().empty());  // the run-up must not trip
  }
  const auto events = drivetrain.events();
  REQUIRE(!events.empty());
  CHECK(events[0].kind == under_speed_trip);
  CHECK(events[0].time == Approx(begin + time_to(10, overload) + 0.3).epsilon(1e-7));
}

TEST_CASE("A short dip in speed does not trip", "[mbd][protection]") {
  DrivetrainParameters machine = droop_machine();
  machine.protection = {.under_speed = 0.5, .under_speed_delay = 1.0};
  Drivetrain drivetrain(machine);
  double slowest = 20;
  for (int k = 0; k < 4000; ++k) {
    exchange(drivetrain, window_number(k, 5e-3), [&](double, double) { return k % 2000 < 220 ? 60e3 : 0.0; });
    slowest = std::min(slowest, drivetrain.state().speed);
  }
  CHECK(slowest < 10);
  CHECK(drivetrain.events().empty());
}

TEST_CASE("After a trip: coasts or brakes to a standstill", "[mbd][protection]") {
  DrivetrainParameters machine = droop_machine();
  machine.losses.no_load_power = 40e3;  // 2 kN m
  machine.protection = {.instantaneous_ratio = 2, .rated_torque = 10e3, .brake_torque = GENERATE(0.0, 6e3)};
  const double brake = machine.protection.brake_torque;
  Drivetrain drivetrain(machine);
  const auto load = [&](double, double) { return drivetrain.state().motor.sense != 0 ? 30e3 : 0.0; };
  for (int k = 0; k < 15000; ++k) exchange(drivetrain, window_number(k, 2e-3), load);
  const auto events = drivetrain.events();
  REQUIRE(events.size() == 2);
  CHECK(events[0].kind == instantaneous_trip);
  CHECK(events[1].kind == standstill);
  CHECK(events[1].time - events[0].time == Approx(12 * 4000 / (2e3 + brake)).epsilon(2e-3));  // one window's load
  CHECK_FALSE(drivetrain.stalled());
  CHECK(drivetrain.stuck());
  CHECK(drivetrain.motor_torque() == 0);
  CHECK(std::abs(drivetrain.energy_residual()) < 1e-3 * drivetrain.state().start_energy);
}

TEST_CASE("Restart, forward or reversed, up to the earlier speed", "[mbd][protection]") {
  DrivetrainParameters machine = droop_machine();
  const bool reversed = GENERATE(false, true);
  machine.protection = {
      .under_speed = 0.5, .brake_torque = 20e3, .restart_delay = 6, .restarts = 2, .restart_reversed = reversed};
  Drivetrain drivetrain(machine);
  const auto jam = [&](double, double) {  // clears while the motor is off
    const SwitchState& motor = drivetrain.state().motor;
    return motor.restarts == 0 && motor.sense != 0 ? 80e3 : 0.0;
  };
  for (int k = 0; k < 30000; ++k) exchange(drivetrain, window_number(k, 1e-3), jam);
  const auto events = drivetrain.events();
  REQUIRE(events.size() == 3);
  CHECK(events[0].kind == under_speed_trip);
  CHECK(events[1].kind == standstill);
  CHECK(events[2].kind == (reversed ? reversed_restart : restart));
  CHECK(events[2].time == Approx(events[0].time + 6).epsilon(1e-9));
  CHECK(drivetrain.state().speed == Approx(reversed ? -20 : 20).epsilon(1e-4));
  CHECK(drivetrain.state().motor.restarts == 1);
}

TEST_CASE("A motor that draws too much current at its start trips immediately at every restart", "[mbd][protection]") {
  DrivetrainParameters machine = droop_machine();
  machine.start = DrivetrainStart::rest;
  machine.protection = {.instantaneous_ratio = 2, .rated_torque = 10e3, .restart_delay = 1, .restarts = 2};
  const auto events = events_of(machine, 0, 5, GENERATE(3, 1000));
  REQUIRE(events.size() == 5);
  const DriveEventKind wanted[] = {instantaneous_trip, restart, instantaneous_trip, restart, instantaneous_trip};
  for (std::size_t k = 0; k < 5; ++k) {
    CHECK(events[k].kind == wanted[k]);
    CHECK(events[k].time == Approx(double((k + 1) / 2)).margin(1e-9));
  }
}

TEST_CASE("Voltage: torque of a cage is proportional to its square, so run-up takes 1/V^2 as long",
          "[mbd][protection]") {
  const double ratio = GENERATE(0.7, 1.0, 1.1);
  DrivetrainParameters machine{.motor = textbook_kloss(), .eccentric_inertia = 500, .start = DrivetrainStart::rest};
  machine.voltage = {{0}, {ratio}};
  Drivetrain drivetrain(machine);
  const double at_half_slip = 95.482868 / (ratio * ratio);
  run(drivetrain, at_half_slip, 20, no_rock);
  CHECK(drivetrain.state().speed == Approx(50).epsilon(1e-7));
}

TEST_CASE("Soft start: a ramp of voltage, droop integrated by hand", "[mbd][protection]") {
  // J dw/dt = T0 (V(t) - w/ws), V = t / r up to r: w = ws (t - tau (1 - exp(-t / tau))) / r.
  DrivetrainParameters machine = droop_machine();
  machine.start = DrivetrainStart::rest;
  machine.losses = {};
  machine.voltage = {{0, 3}, {1e-9, 1}};  // from almost 0, because it cannot start at 0 V
  Drivetrain drivetrain(machine);
  run(drivetrain, 2.5, GENERATE(1, 25, 2500), no_rock);
  CHECK(drivetrain.state().speed == Approx(20 * (2.5 - tau * (1 - std::exp(-2.5 / tau))) / 3).epsilon(1e-6));
}

TEST_CASE("Coupling spring: the two-mass oscillation, and its energy", "[mbd][protection]") {
  const double stiffness = 4e5;
  DrivetrainParameters machine = crusher_62_75(DroopMotor{.synchronous_speed = 600 * rpm, .stall_torque = 1e-6});
  machine.spring = {.stiffness = stiffness};
  Shaft shaft(machine);
  ShaftMotion motion{.speed = 10, .direction = +1, .motor_speed = 37.5, .twist = 0.01};
  const double energy = shaft.energy(motion);
  const double frequency = std::sqrt(stiffness * (1 / 50.0 + 3.75 * 3.75 / 5000));  // rad/s
  const double time = 12.3 / frequency;
  for (int k = 0; k < 100; ++k) shaft.advance(time / 100, 0.0, motion);
  CHECK(motion.twist == Approx(0.01 * std::cos(12.3)).epsilon(1e-6));
  CHECK(shaft.energy(motion) == Approx(energy).epsilon(1e-9));
}

TEST_CASE("A stiff coupling spring acts as a rigid shaft", "[mbd][protection]") {
  DrivetrainParameters machine = crusher_62_75(induction_450kw());
  machine.losses.no_load_power = 100e3;
  Drivetrain rigid(machine);
  machine.spring = {.stiffness = 1e9, .damping = 1e4};
  Drivetrain sprung(machine);
  const auto load = [](double begin, double) { return 15e3 * (1 + std::sin(5 * begin)); };
  run(rigid, 1, 500, load);
  run(sprung, 1, 500, load);
  CHECK(sprung.state().speed == Approx(rigid.state().speed).epsilon(1e-6));
  CHECK(sprung.state().loss_work == Approx(rigid.state().loss_work).epsilon(1e-5));
  CHECK(std::abs(sprung.energy_residual()) < 1e-4 * sprung.state().motor_work);
}

TEST_CASE("Protection out of range is refused", "[mbd][protection]") {
  const auto refused = [](auto change) {
    DrivetrainParameters machine = droop_machine();
    change(machine);
    CHECK_THROWS_AS(Drivetrain(machine), BadInput);
  };
  refused([](auto& m) { m.protection = {.overload_time = 30}; });  // rated_torque of a droop is not known
  refused([](auto& m) { m.protection = {.under_speed = 1.5}; });
  refused([](auto& m) { m.voltage = {{0, 0}, {1, 1}}; });
  refused([](auto& m) { m.voltage = {{0}, {-1}}; });
  refused([](auto& m) { m.spring.stiffness = 1e5; });                              // the motor has no inertia
  refused([](auto& m) { m.bearings.inner = {.friction = 0.01, .radius = 0.3}; });  // the depth is missing
  refused([](auto& m) { m.mantle_inertia = -1; });
}

}  // namespace gyro
