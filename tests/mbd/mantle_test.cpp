// SPDX-License-Identifier: GPL-3.0-or-later
// The mantle's spin as a second degree of freedom: signs, dragging, rolling, bearing friction, energy.
#include "app/verify/fixtures/drives.hpp"
#include "mbd/shaft.hpp"
#include "tests/catch.hpp"

#include <algorithm>

namespace gyro {
namespace {

using namespace fixtures;

constexpr double tilt_sine = 0.0217 / 4.2, surface_radius = 0.953, surface_depth = 4.2;
const double tilt_cosine = std::sqrt(1 - tilt_sine * tilt_sine);

/// 62-75 whose mantle spins, with a torque of each bearing that does not depend on the load.
DrivetrainParameters spinning_machine(const Motor& motor, double inner, double spider, double outer = 0) {
  DrivetrainParameters machine = crusher_62_75(motor);
  machine.mantle_inertia = 8000;
  machine.bearings = {.outer = {.friction = 0.01, .radius = 0.5, .idle_force = outer / 0.005},
                      .inner = {.friction = 0.01, .radius = 0.3, .idle_force = inner / 0.003},
                      .spider = {.friction = 0.01, .radius = 0.25, .idle_force = spider / 0.0025},
                      .depth = 5.4,
                      .tilt_sine = tilt_sine};
  return machine;
}

/// Rock that sticks to one point of the mantle, where it is nearest to the concave, with a force -c v. By virtual
/// work: f = -c (w h sin b + sigma rho) along u x n, T_s = f rho, T_c = -f h sin b.
MantleLoad sticky_rock(const MantlePath& path, double length, double c) {
  const double force = -c * (path.speed * surface_depth * tilt_sine + path.spin * surface_radius);
  MantleLoad load;
  load.spin_torque = force * surface_radius;
  load.resisting_torque = -force * surface_depth * tilt_sine;
  load.work = (load.resisting_torque * path.speed - load.spin_torque * path.spin) * length;
  return load;
}

void run_on_sticky_rock(Drivetrain& drivetrain, double c, double length, int windows) {
  for (int k = 0; k < windows; ++k) {
    const Window window = window_number(k, length);
    drivetrain.advance(window, sticky_rock(drivetrain.predict(window), length, c));
  }
}

}  // namespace

TEST_CASE("Statics of the mantle: force times lever at bushing and spider", "[mbd][mantle]") {
  const Vec3d axis{0, 0, 1}, force{2.5e6, 0, 0};
  const double at = 4.0, depth = 5.4;  // below the pivot [m]
  const BearingForces forces = bearing_forces(force, cross(Vec3d{0, 0, -at}, force), axis, depth);
  CHECK(forces.bushing == Approx(2.5e6 * at / depth));
  CHECK(forces.spider == Approx(2.5e6 * (1 - at / depth)));
  const Vec3d down{0, 0, -1e6};  // the piston below the mantle carries it
  CHECK(bearing_forces(down, Vec3d{}, axis, depth).spider == Approx(0).margin(1e-6));
}

TEST_CASE("No-slip point: the mantle rolls backwards on the rock", "[mbd][mantle]") {
  Drivetrain drivetrain(spinning_machine(ConstantSpeedMotor{600 * rpm}, 0, 0));
  CHECK(drivetrain.state().spin == Approx(160 * rpm * tilt_cosine));  // dragged along by the eccentric until now
  run_on_sticky_rock(drivetrain, 1e6, 1e-3, 2000);
  // sigma = -w e / rho: -3.6 rpm at 160 rpm.
  const double rolling = -160 * rpm * surface_depth * tilt_sine / surface_radius;
  CHECK(rolling / rpm == Approx(-3.64).margin(0.01));
  CHECK(drivetrain.state().spin == Approx(rolling).epsilon(1e-6));
  CHECK(drivetrain.state().slip == -1);
}

TEST_CASE("Rolling mantle: the bushing's drag is carried by rock and eccentric", "[mbd][mantle]") {
  const double inner = 2000;
  const DrivetrainParameters machine = spinning_machine(paper_droop(), inner, 0);
  Drivetrain drivetrain(machine);
  run_on_sticky_rock(drivetrain, 2e5, 5e-3, 5000);
  // The rock transmits the drag: f rho = -T_inner, T_c = T_inner e / rho; the eccentric carries T_c + T_inner cos b.
  const double rock = inner * surface_depth * tilt_sine / surface_radius;
  CHECK(drivetrain.state().spin_torque == Approx(-inner).epsilon(1e-6));
  CHECK(drivetrain.state().rock_torque == Approx(rock).epsilon(1e-6));
  const double slope = 21e3 / (35 * rpm);  // of the paper's droop, at the eccentric
  CHECK(drivetrain.state().speed == Approx(160 * rpm - (rock + inner * tilt_cosine) / slope).epsilon(1e-8));
}

TEST_CASE("Fully dragged mantle: one rigid body with the eccentric, loaded by the rock's torque about it",
          "[mbd][mantle]") {
  const double inner = 5000, spider = 800, spin_torque = -3000, rock = 9000;
  const DrivetrainParameters machine = spinning_machine(paper_droop(), inner, spider);
  Drivetrain drivetrain(machine);
  CHECK(drivetrain.state().slip == 0);
  constexpr double length = 10e-3;
  double apart = 0;
  for (int k = 0; k < 6000; ++k) {
    const Window window = window_number(k, length);
    const MantlePath path = drivetrain.predict(window);
    drivetrain.advance(window, {.work = (rock * path.speed - spin_torque * path.spin) * length,
                                .resisting_torque = rock,
                                .spin_torque = spin_torque});
    apart = std::max(apart, std::abs(drivetrain.state().spin - tilt_cosine * drivetrain.state().speed));
  }
  CHECK(apart < 1e-14);
  CHECK(drivetrain.state().slip == 0);
  const double slope = 21e3 / (35 * rpm);
  const double load = rock - spin_torque * tilt_cosine + spider;  // Omega = w z: the spider brakes both
  CHECK(drivetrain.state().speed == Approx(160 * rpm - load / slope).epsilon(1e-8));
}

TEST_CASE("A mantle at rest is accelerated at T / J_a and then turns with the eccentric", "[mbd][mantle]") {
  const double inner = 3000;
  const int windows = GENERATE(1, 7, 1000);
  Shaft shaft(spinning_machine(ConstantSpeedMotor{600 * rpm}, inner, 0));
  ShaftMotion motion{.speed = 160 * rpm, .direction = +1, .slip = -1};
  const double caught = 8000 * 160 * rpm * tilt_cosine / inner;  // [s]
  double time = 0, spun = 0;
  for (; time < 0.9 * caught; time += 1.8 * caught / windows / 2) {
    spun += shaft.advance(1.8 * caught / windows / 2, ShaftLoad{}, motion).spin_angle;
  }
  const double sure = std::min(time, caught);
  CHECK(spun == Approx(0.5 * inner / 8000 * sure * sure + (time - sure) * 160 * rpm * tilt_cosine).epsilon(1e-8));
  shaft.advance(1.2 * caught - time, ShaftLoad{}, motion);
  CHECK(motion.slip == 0);
  CHECK(motion.spin == Approx(tilt_cosine * motion.speed).epsilon(1e-15));
}

TEST_CASE("Idle: closed form of spider against bushing agrees with a long run", "[mbd][mantle]") {
  const auto [inner, spider] = GENERATE(table<double, double>({{600, 1000}, {1000, 600}, {990, 1000}}));
  const DrivetrainParameters machine = spinning_machine(paper_droop(), inner, spider, 1500);
  const IdleMantle idle = idle_mantle(machine);
  CHECK(idle.slip == (inner > spider ? 0 : -1));
  Drivetrain drivetrain(machine);
  const DrivetrainState start = drivetrain.state();
  CHECK(start.spin == Approx(idle.spin_ratio * start.speed));
  run(drivetrain, 5, 1000, no_rock);
  CHECK(drivetrain.state().speed == Approx(start.speed).epsilon(1e-12));
  CHECK(drivetrain.state().spin == Approx(start.spin).epsilon(1e-10));
  CHECK(drivetrain.means().loss_power == Approx(idle.torque * start.speed).epsilon(1e-9));
}

TEST_CASE("The mantle breaks loose beyond the bushing's torque, and is dragged along again", "[mbd][mantle]") {
  const double inner = 4000;
  Shaft shaft(spinning_machine(induction_450kw(), inner, 0));
  ShaftMotion motion = shaft.start();
  const auto under = [&](double spin_torque, double duration) {
    shaft.advance(duration, ShaftLoad{.rock_torque = 5000, .spin_torque = spin_torque}, motion);
    return motion.slip;
  };
  CHECK(under(-0.98 * inner, 0.5) == 0);
  CHECK(under(-1.05 * inner, 0.5) == -1);
  CHECK(motion.spin < tilt_cosine * motion.speed);
  CHECK(under(-0.5 * inner, 5) == 0);
  CHECK(under(1.5 * inner, 0.5) == +1);
  CHECK(under(0, 5) == 0);
}

TEST_CASE("Bearing friction grows with the crushing force", "[mbd][mantle]") {
  DrivetrainParameters machine = crusher_62_75(ConstantSpeedMotor{600 * rpm});
  machine.bearings = {.outer = {.friction = 0.006, .radius = 0.4}, .depth = 5.4};
  Drivetrain drivetrain(machine);
  const Window window = window_number(0, 1e-3);
  const MantlePath path = drivetrain.predict(window);
  drivetrain.advance(window, {.work = 21e3 * path.speed * 1e-3, .bearings = {.bushing = 2.5e6}});
  CHECK(drivetrain.means().loss_power == Approx(0.006 * 2.5e6 * 0.4 * 160 * rpm));  // 6 kN m
  CHECK(drivetrain.means().motor_power == Approx((21e3 + 6e3) * 160 * rpm));
}

TEST_CASE("Energy balances with spin, bearings, gear losses and spring together", "[mbd][mantle]") {
  const double stiffness = GENERATE(0.0, 4e5);
  const double length = GENERATE(0.5e-3, 20e-3);
  DrivetrainParameters machine = spinning_machine(nema_motor(NemaDesign::c, 450e3, 600 * rpm), 1500, 900, 400);
  machine.gear_efficiency = 0.96;
  machine.losses = {.no_load_power = 60e3, .viscous = 20};
  machine.spring = {.stiffness = stiffness, .damping = stiffness > 0 ? 200.0 : 0};
  Shaft shaft(machine);
  ShaftMotion motion = shaft.start();
  const double energy_before = shaft.energy(motion);
  double motor_work = 0, spent = 0, gained = 0;
  int slips = 0;
  for (int k = 0; k < 2000; ++k) {
    const ShaftLoad load{.rock_torque = 15e3 * (1 + std::sin(0.13 * k)),
                         .spin_torque = 3e3 * std::sin(0.07 * k) - 1e3,
                         .bearings = {.bushing = 1e5 * (1 + std::sin(0.11 * k)), .spider = 5e4}};
    const int before = motion.slip;
    const ShaftAdvance turn = shaft.advance(length, load, motion);
    slips += motion.slip != before;
    motor_work += turn.motor_work;
    spent += load.rock_torque * turn.angle - load.spin_torque * turn.spin_angle + turn.loss_work + turn.kinetic_gain;
    gained += turn.kinetic_gain;
  }
  CAPTURE(stiffness, length, motor_work, spent, slips);
  CHECK(slips > 2);
  CHECK(motor_work > 1e4);
  CHECK(std::abs(motor_work / spent - 1) < 1e-6);
  CHECK(gained == Approx(shaft.energy(motion) - energy_before).epsilon(1e-6));
}

TEST_CASE("Stall with a spinning mantle: both come to rest exactly", "[mbd][mantle]") {
  DrivetrainParameters machine = spinning_machine(induction_450kw(), 1500, 1000);
  machine.mantle_inertia = 400;
  machine.losses = {.no_load_power = 100e3, .load_factor = 1};
  Drivetrain drivetrain(machine);
  const double overload = 1.1 * 3.75 * induction_450kw().breakdown_torque();
  int changes = 0;
  for (int k = 0; k < 4000; ++k) {
    const DrivetrainState before = drivetrain.state();
    const Window window = window_number(k, 2e-3);
    const MantlePath path = drivetrain.predict(window);
    drivetrain.advance(
        window,
        {.work = (overload * path.speed - 500 * path.spin) * 2e-3, .resisting_torque = overload, .spin_torque = 500});
    const DrivetrainState& now = drivetrain.state();
    changes += now.direction != before.direction || now.slip != before.slip;
    if (k < 3000) continue;
    REQUIRE(now.speed == 0);
    REQUIRE(now.spin == 0);
    REQUIRE(path.spin == 0);
    REQUIRE(path.speed == 0);
  }
  CHECK(drivetrain.stalled());
  CHECK(changes < 6);
}

}  // namespace gyro
