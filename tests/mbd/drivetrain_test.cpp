// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/fixtures/drives.hpp"
#include "core/base/errors.hpp"
#include "core/base/saved_state.hpp"
#include "tests/catch.hpp"

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace gyro {
namespace {

using namespace fixtures;

/// A machine with all options, under a load that depends on the angle.
DrivetrainParameters full_machine() {
  DrivetrainParameters machine = crusher_62_75(induction_450kw());
  machine.gear_efficiency = 0.97;
  machine.losses = {.no_load_power = 100e3, .load_factor = 0.05, .viscous = 10};
  return machine;
}

double crushing(double begin, double end) {
  const double middle = (begin + end) / 2;
  return 14e3 * (1 + std::sin(5 * middle)) + 3e3 * std::sin(31 * middle);
}

/// Adds the bytes of all fields.
template <class T>
void add_bits(const T& value, std::vector<std::uint8_t>& all) {
  if constexpr (HasFields<T>) {
    T::for_each_field([&](const char*, const auto& field) { add_bits(field, all); }, value);
  } else if constexpr (std::is_arithmetic_v<T>) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
    all.insert(all.end(), bytes, bytes + sizeof value);
  } else {
    for (const auto& number : value) add_bits(number, all);
  }
}
std::vector<std::uint8_t> bits(const DrivetrainState& state) {
  std::vector<std::uint8_t> all;
  add_bits(state, all);
  return all;
}

}  // namespace

TEST_CASE("62-75 idles at 600 and 160 rpm without losses", "[mbd][drivetrain]") {
  const Motor motor = GENERATE(Motor{paper_droop()}, Motor{induction_450kw()});
  Drivetrain drivetrain(crusher_62_75(motor));
  CHECK(drivetrain.motor_speed() == Approx(600 * rpm).epsilon(1e-15));
  CHECK(drivetrain.state().speed == Approx(160 * rpm).epsilon(1e-15));
  run(drivetrain, 1, 1000, no_rock);
  CHECK(drivetrain.state().speed == Approx(160 * rpm).epsilon(1e-14));
  CHECK(drivetrain.state().angle == Approx(160 * rpm).epsilon(1e-12));
}

TEST_CASE("62-75 with 100 kW of losses idles a little below, in balance", "[mbd][drivetrain]") {
  DrivetrainParameters machine = crusher_62_75(induction_450kw());
  machine.losses.no_load_power = 100e3;
  Drivetrain drivetrain(machine);
  const double at_start = drivetrain.state().speed;
  CHECK(drivetrain.motor_speed() > 590 * rpm);
  CHECK(drivetrain.motor_speed() < 600 * rpm);
  run(drivetrain, 1, 1000, no_rock);
  CHECK(drivetrain.state().speed == Approx(at_start).epsilon(1e-13));
  // 100 kW at the rated speed, as a constant torque.
  CHECK(drivetrain.means().loss_power ==
        Approx(100e3 * drivetrain.motor_speed() / (0.9833 * 600 * rpm)).epsilon(1e-12));
  CHECK(drivetrain.means().motor_power == Approx(drivetrain.means().loss_power).epsilon(1e-9));
}

TEST_CASE("Run-up from rest ends at 600 and 160 rpm", "[mbd][drivetrain]") {
  const Motor motor = GENERATE(Motor{paper_droop()}, Motor{induction_450kw()});
  DrivetrainParameters machine = crusher_62_75(motor);
  machine.start = DrivetrainStart::rest;
  Drivetrain drivetrain(machine);
  CHECK(drivetrain.stuck());
  double before = 0;
  bool rises = true;
  for (int k = 0; k < 20000; ++k) {  // 20 s in steps of 1 ms
    exchange(drivetrain, window_number(k, 1e-3), no_rock);
    rises = rises && drivetrain.state().speed >= before * (1 - 1e-12);
    before = drivetrain.state().speed;
  }
  CHECK(rises);
  CHECK_FALSE(drivetrain.stalled());
  CHECK(drivetrain.motor_speed() / rpm == Approx(600).epsilon(1e-3));
  CHECK(drivetrain.state().speed / rpm == Approx(160).epsilon(1e-3));
  CHECK(std::abs(drivetrain.energy_residual()) < 1e-6 * drivetrain.state().motor_work);
}

TEST_CASE("Constant speed: exact angle, torque as needed", "[mbd][drivetrain]") {
  DrivetrainParameters machine = crusher_62_75(ConstantSpeedMotor{.speed = 600 * rpm});
  machine.gear_efficiency = 0.96;
  machine.losses = {.no_load_power = 100e3, .load_factor = 0.05};
  machine.start_angle = 0.3;
  Drivetrain drivetrain(machine);
  const double speed = 600 * rpm / 3.75;
  for (int k = 0; k < 2000; ++k) {
    const Window window = window_number(k, 0.5e-3, 1000);
    const MantlePath path = drivetrain.predict(window);
    REQUIRE(path.speed == speed);
    REQUIRE(path.angle == 0.3 + speed * window.begin());
    drivetrain.advance(window, {.work = 21e3 * speed * window.length()});
    REQUIRE(drivetrain.state().angle == 0.3 + speed * window.end());
  }
  CHECK(drivetrain.means().mantle_torque == Approx(21e3));
  const double needed = (1.05 * 21e3 + 100e3 / speed) / 0.96 / 3.75;
  CHECK(drivetrain.means().motor_torque == Approx(needed));
  CHECK(drivetrain.motor_torque() == Approx(needed));
  CHECK(drivetrain.means().motor_power == Approx(needed * 600 * rpm));
  CHECK(std::abs(drivetrain.energy_residual()) < 1e-9 * drivetrain.state().motor_work);
}

TEST_CASE("Operating point of the paper: 21 kN m slows the droop motor down to 125 rpm", "[mbd][drivetrain]") {
  Drivetrain drivetrain(crusher_62_75(paper_droop()));
  run(drivetrain, 20, 4000, [](double, double) { return 21e3; });
  CHECK(drivetrain.state().speed / rpm == Approx(125).epsilon(1e-6));
  CHECK(drivetrain.means().crushing_power == Approx(21e3 * 125 * rpm).epsilon(1e-6));
}

TEST_CASE("The wall's path never jumps", "[mbd][drivetrain]") {
  Drivetrain drivetrain(full_machine());
  MantlePath before = exchange(drivetrain, window_number(0, 1e-3), crushing);
  double gap = 0;
  for (int k = 1; k < 1000; ++k) {
    const MantlePath path = exchange(drivetrain, window_number(k, 1e-3), crushing);
    REQUIRE(path.angle == before.angle + before.speed * 1e-3);
    gap = std::max(gap, std::abs(drivetrain.state().wall_angle - drivetrain.state().angle));
    before = path;
  }
  CAPTURE(gap);
  CHECK(gap < 2e-6);  // [rad]: H^2 / 2 J for a change of 20 kN m within a window
}

TEST_CASE("A run that continues from a saved state has the same bits", "[mbd][drivetrain]") {
  Drivetrain whole(full_machine()), first(full_machine()), second(full_machine());
  for (int k = 0; k < 400; ++k) exchange(whole, window_number(k, 1e-3), crushing);
  for (int k = 0; k < 150; ++k) exchange(first, window_number(k, 1e-3), crushing);
  SavedState saved;
  saved.put_fields("drivetrain", first.state());
  second.restore(saved.get_fields<DrivetrainState>("drivetrain"));
  for (int k = 150; k < 400; ++k) exchange(second, window_number(k, 1e-3), crushing);
  CHECK(bits(whole.state()) == bits(second.state()));
}

TEST_CASE("Means of the windows add up to the work of the run", "[mbd][drivetrain]") {
  Drivetrain drivetrain(full_machine());
  double motor = 0, loss = 0, rock = 0, residual = 0;
  for (int k = 0; k < 500; ++k) {
    exchange(drivetrain, window_number(k, 1e-3), crushing);
    const DrivetrainMeans& means = drivetrain.means();
    motor += means.motor_power * 1e-3;
    loss += means.loss_power * 1e-3;
    rock += means.crushing_power * 1e-3;
    residual += means.power_residual * 1e-3;
  }
  CHECK(motor == Approx(drivetrain.state().motor_work));
  CHECK(loss == Approx(drivetrain.state().loss_work));
  CHECK(rock == Approx(drivetrain.state().rock_work));
  CHECK(residual == Approx(drivetrain.energy_residual()).margin(1e-6 * motor));
}

TEST_CASE("Wrong use and wrong numbers are refused", "[mbd][drivetrain]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Drivetrain drivetrain(full_machine());
  CHECK_THROWS_AS(drivetrain.advance(window_number(0, 1e-3), {}), std::logic_error);
  drivetrain.predict(window_number(0, 1e-3));
  CHECK_THROWS_AS(drivetrain.advance(window_number(1, 1e-3), {}), std::logic_error);
  CHECK_THROWS_AS(drivetrain.advance(window_number(0, 1e-3), {.work = nan}), StoppedByGuard);

  const auto refused = [](auto change) {
    DrivetrainParameters machine = full_machine();
    change(machine);
    CHECK_THROWS_AS(Drivetrain(machine), BadInput);
  };
  refused([](auto& machine) { machine.gear_ratio = 0; });
  refused([](auto& machine) { machine.gear_efficiency = 1.1; });
  refused([](auto& machine) { machine.motor_inertia = machine.eccentric_inertia = 0; });
  refused([](auto& machine) { machine.eccentric_inertia = -1; });
  refused([](auto& machine) { machine.losses.load_factor = -0.1; });
  refused([](auto& machine) { machine.losses.no_load_power = 2e6; });  // more than breakdown
  refused([nan](auto& machine) { machine.losses.viscous = nan; });
  refused([](auto& machine) {  // 300 kW: the running motor carries it, but it is more than the starting torque
    machine.losses.no_load_power = 300e3;
    machine.start = DrivetrainStart::rest;
  });
  refused([](auto& machine) {
    machine.motor = ConstantSpeedMotor{.speed = 60};
    machine.start = DrivetrainStart::rest;
  });
}

}  // namespace gyro
