// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/fixtures/drives.hpp"
#include "mbd/shaft.hpp"
#include "tests/catch.hpp"

#include <algorithm>

namespace gyro {
namespace {

using namespace fixtures;

constexpr double length = 2e-3;  // of a window [s]

/// 62-75 with its induction motor and losses.
DrivetrainParameters machine_with_losses(double load_factor) {
  DrivetrainParameters machine = crusher_62_75(induction_450kw());
  machine.losses = {.no_load_power = 100e3, .load_factor = load_factor};
  return machine;
}

double breakdown_at_eccentric() {
  return 3.75 * induction_450kw().breakdown_torque();
}

/// Changes of direction, and motion of the wall while the shaft was stuck before and after a window.
struct Watch {
  int changes = 0;
  double wall_creep = 0;  ///< [rad/s]
  template <class Torque>
  void window(Drivetrain& drivetrain, std::int64_t k, const Torque& torque) {
    const double before = drivetrain.state().direction;
    const MantlePath path = exchange(drivetrain, window_number(k, length), torque);
    if (drivetrain.state().direction != before) ++changes;
    if (drivetrain.stuck() && before == 0) wall_creep = std::max(wall_creep, std::abs(path.speed));
  }
};

}  // namespace

TEST_CASE("Overload with friction: the machine stops, stays exactly at rest and starts again", "[mbd][stall]") {
  const double load = 1.1 * breakdown_at_eccentric();
  const auto overload = [&](double, double) { return load; };
  // Friction that grows with the load holds the rest of the overload: self-locking.
  Drivetrain drivetrain(machine_with_losses(1.0));
  Watch watch;
  std::int64_t k = 0;
  while (!drivetrain.stuck() && k < 10000) watch.window(drivetrain, k++, overload);
  REQUIRE(drivetrain.stuck());
  REQUIRE(drivetrain.stalled());
  CHECK(*drivetrain.stall_time() > (k - 1) * length);
  CHECK(*drivetrain.stall_time() <= k * length);

  const double angle = drivetrain.state().angle, work = drivetrain.state().motor_work;
  for (int n = 0; n < 2000; ++n) {
    watch.window(drivetrain, k++, overload);
    REQUIRE(drivetrain.state().speed == 0);
    REQUIRE(drivetrain.state().angle == angle);
    REQUIRE(drivetrain.means().motor_power == 0);
  }
  CHECK(watch.changes == 1);
  CHECK(watch.wall_creep == 0);
  CHECK(drivetrain.state().motor_work == work);
  CHECK(drivetrain.means().motor_torque == Approx(induction_450kw().torque(0)));

  const double stall_time = *drivetrain.stall_time();
  for (int n = 0; n < 10000; ++n) watch.window(drivetrain, k++, no_rock);  // 20 s
  CHECK(watch.changes == 2);
  CHECK(drivetrain.state().speed == Approx(idle_speed(machine_with_losses(1.0))).epsilon(1e-6));
  CHECK(*drivetrain.stall_time() == stall_time);  // the first one is kept
}

TEST_CASE("Overload without friction drives the machine backwards, through zero once", "[mbd][stall]") {
  const double load = 1.1 * breakdown_at_eccentric();
  Drivetrain drivetrain(crusher_62_75(induction_450kw()));
  Watch watch;
  std::int64_t k = 0;
  for (; k < 1500; ++k) watch.window(drivetrain, k, [&](double, double) { return load; });
  CHECK(watch.changes == 1);
  CHECK(drivetrain.state().direction == -1);
  CHECK(drivetrain.state().speed < -1);
  CHECK(std::abs(drivetrain.energy_residual()) < 1e-6 * drivetrain.state().start_energy);
  for (; k < 15000; ++k) watch.window(drivetrain, k, no_rock);  // the motor drives it forward again
  CHECK(watch.changes == 2);
  CHECK(drivetrain.state().speed == Approx(160 * rpm).epsilon(1e-6));
}

TEST_CASE("A stuck shaft moves again only beyond the static friction", "[mbd][stall]") {
  const DrivetrainParameters machine = machine_with_losses(0.2);
  Shaft shaft(machine);
  const double motor = 3.75 * induction_450kw().torque(0);
  const double idle = machine.eccentric_losses().constant_torque;
  // Forward while motor - T > T0 + f T, backward when T - motor > T0 + f T.
  const double forward_limit = (motor - idle) / 1.2, backward_limit = (motor + idle) / 0.8;
  const auto direction_under = [&](double torque) {
    ShaftMotion motion;
    shaft.advance(length, torque, motion);
    CHECK((motion.direction == 0) == (motion.speed == 0));
    return motion.direction;
  };
  CHECK(direction_under(forward_limit * (1 - 1e-9)) == +1);
  CHECK(direction_under(forward_limit * (1 + 1e-9)) == 0);
  CHECK(direction_under(backward_limit * (1 - 1e-9)) == 0);
  CHECK(direction_under(backward_limit * (1 + 1e-9)) == -1);
}

TEST_CASE("An elastic chamber drives the machine back with less energy than it stored", "[mbd][stall]") {
  const double stiffness = 2e6, touch = 1.0;  // [N m/rad], [rad]
  const auto energy = [&](double angle) { return 0.5 * stiffness * std::pow(std::max(0.0, angle - touch), 2); };
  const auto cavity = [&](double begin, double end) {
    return begin == end ? stiffness * std::max(0.0, end - touch) : (energy(end) - energy(begin)) / (end - begin);
  };
  Drivetrain drivetrain(machine_with_losses(0.05));
  Watch watch;
  double stored = 0, backward_energy = 0;
  for (int k = 0; k < 400; ++k) {
    watch.window(drivetrain, k, cavity);
    stored = std::max(stored, energy(drivetrain.state().angle));
    if (drivetrain.state().speed < 0) backward_energy = std::max(backward_energy, drivetrain.kinetic_energy());
  }
  CAPTURE(stored, backward_energy, drivetrain.energy_residual());
  CHECK(drivetrain.stalled());
  CHECK(watch.changes == 1);
  CHECK(drivetrain.state().angle < touch);  // out of the rock again
  CHECK(backward_energy > 0.8 * stored);
  CHECK(backward_energy < 0.95 * stored);  // bearings dissipate 5 % in each direction, and there is the idle loss
  CHECK(std::abs(drivetrain.energy_residual()) < 1e-3 * stored);
}

TEST_CASE("A machine on a spring oscillates, comes to rest by friction and stays at rest", "[mbd][stall]") {
  const double stiffness = 2e6, middle = 1.0;  // [N m/rad], [rad]
  const auto spring = [&](double begin, double end) { return stiffness * ((begin + end) / 2 - middle); };
  Drivetrain drivetrain(machine_with_losses(0.05));
  Watch watch;
  int k = 0;
  while (k < 10000 && !drivetrain.stuck()) watch.window(drivetrain, k++, spring);
  REQUIRE(drivetrain.stuck());
  // Rest lies where friction covers the difference of motor and spring: |motor - T| <= T0 + f |T|.
  const double angle = drivetrain.state().angle, torque = stiffness * (angle - middle);
  const double motor = 3.75 * induction_450kw().torque(0);
  CHECK(std::abs(motor - torque) < machine_with_losses(0.05).eccentric_losses().dry_torque(torque) * 1.01);

  const int changes = watch.changes;
  for (int n = 0; n < 2000; ++n) {
    watch.window(drivetrain, k++, spring);
    REQUIRE(drivetrain.state().speed == 0);
    REQUIRE(drivetrain.state().angle == angle);
  }
  CHECK(watch.changes == changes);
  CHECK(watch.wall_creep == 0);
}

TEST_CASE("Turned back and held: friction stops the machine in backward motion, and an event reports it",
          "[mbd][stall]") {
  // Forward until (1 + f) k x stops it at x0, back to 2 x_b - x0 with x_b = M / ((1 - f) k): held there if that is
  // above M / ((1 + f) k). With f = 0.3 and this spring x0 is about 1.7 M / k, between 1.43 (turned back) and 2.09
  // (held).
  const double stiffness = 3200;  // [N m/rad]
  Drivetrain drivetrain({.motor = DroopMotor{.synchronous_speed = 20, .stall_torque = 50e3},
                         .eccentric_inertia = 4000,
                         .losses = {.load_factor = 0.3}});
  int k = 0;
  const auto window = [&] {
    exchange(drivetrain, window_number(k++, length), [&](double a, double b) { return stiffness * (a + b) / 2; });
  };
  while (k < 6000 && !drivetrain.stuck()) window();
  REQUIRE(drivetrain.stuck());
  const double angle = drivetrain.state().angle, rested = k * length;
  for (int n = 0; n < 500; ++n) window();
  CHECK(drivetrain.state().angle == angle);
  const auto events = drivetrain.events();
  REQUIRE(events.size() == 3);
  CHECK(events[0].kind == DriveEventKind::stall);
  CHECK(events[1].kind == DriveEventKind::turned_back);
  CHECK(events[2].kind == DriveEventKind::held);
  CHECK(events[2].time == Approx(rested).margin(1.01 * length));
}

TEST_CASE("A rigid jam that only resists: rattling decreases with the window", "[mbd][stall]") {
  // The hardest load for held values: it jumps with the direction and has no elasticity at all. The wall
  // reverses up to two windows after the shaft, so the speed may grow by the impulses of three windows.
  const double window = GENERATE(0.5e-3, 1e-3, 2e-3);
  const double load = 1.1 * breakdown_at_eccentric();
  const DrivetrainParameters machine = machine_with_losses(0.05);
  Drivetrain drivetrain(machine);
  const double motor = 3.75 * induction_450kw().torque(0);
  const auto jam = [&](double begin, double end) { return end > begin ? load : end < begin ? -load : motor; };
  double fastest = 0;
  for (int k = 0; k * window < 4; ++k) {
    const bool stalled_before = drivetrain.stalled();
    exchange(drivetrain, window_number(k, window), jam);
    if (stalled_before) fastest = std::max(fastest, std::abs(drivetrain.state().speed));
  }
  const double largest_torque = motor + load + machine.eccentric_losses().dry_torque(load);
  const double impulse_speed = largest_torque * window / machine.effective_inertia();
  CAPTURE(window, fastest, impulse_speed);
  CHECK(drivetrain.stalled());
  CHECK(fastest < 3 * impulse_speed);
}

}  // namespace gyro
