// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/fixtures/drives.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <limits>

namespace gyro {
namespace {

using namespace fixtures;

const CurveMotor catalogue{.speeds = {0, 40, 90, 100, 110}, .torques = {200, 180, 250, 50, -150}};

}  // namespace

TEST_CASE("Kloss: breakdown is the largest torque", "[mbd][motor]") {
  const InductionMotor motor = induction_450kw();
  for (int k = -1000; k <= 2000; ++k) {
    CAPTURE(k);
    CHECK(std::abs(motor.torque(motor.synchronous_speed * k / 1000)) <= motor.breakdown_torque() * (1 + 1e-14));
  }
}

TEST_CASE("Kloss: generator above, plugging below", "[mbd][motor]") {
  const InductionMotor motor = textbook_kloss();
  for (const double slip : {1e-9, 0.01, 0.1, 0.5, 2.0}) {
    CAPTURE(slip);
    const double driving = motor.torque(100 * (1 - slip));
    CHECK(driving > 0);
    CHECK(motor.torque(100 * (1 + slip)) == Approx(-driving).epsilon(1e-6));  // odd in the slip
  }
  CHECK(motor.torque(-50) == Approx(1000 * 2 / (1.5 / 0.1 + 0.1 / 1.5)).epsilon(1e-14));  // s = 1.5
}

TEST_CASE("62-75 name plate: rated torque, slips under load", "[mbd][motor]") {
  const InductionMotor motor = induction_450kw();
  CHECK(motor.rated_torque() * motor.rated_speed() == Approx(450e3).epsilon(1e-14));
  CHECK(motor.breakdown_slip() == Approx(0.0800).epsilon(2e-3));
  CHECK(motor.torque(600 * rpm * (1 - 0.013)) / motor.rated_torque() == Approx(0.78).epsilon(0.02));
  CHECK(motor.torque(600 * rpm * (1 - 0.027)) / motor.rated_torque() == Approx(1.50).epsilon(0.02));
  CHECK(motor.torque(0) / motor.rated_torque() == Approx(0.40).epsilon(0.02));
}

TEST_CASE("Droop of the paper: 160 rpm idle, 21 kN m at 125 rpm", "[mbd][motor]") {
  const DroopMotor motor = paper_droop();
  const double ratio = 3.75;
  CHECK(motor.torque(ratio * 160 * rpm) == Approx(0).margin(1e-9));
  CHECK(ratio * motor.torque(ratio * 125 * rpm) == Approx(21e3).epsilon(1e-13));
  const double slope = ratio * (motor.torque(0) - motor.torque(ratio)) / 1;  // per rad/s of the eccentric
  CHECK(slope == Approx(5729.6).epsilon(1e-5));
}

TEST_CASE("Curve: linear between the points, and as documented beyond them", "[mbd][motor]") {
  CHECK(catalogue.torque(0) == 200);
  CHECK(catalogue.torque(20) == Approx(190));
  CHECK(catalogue.torque(90) == Approx(250));
  CHECK(catalogue.torque(95) == Approx(150));
  CHECK(catalogue.torque(110) == Approx(-150));
  CHECK(catalogue.torque(-30) == 200);           // the locked-rotor torque continues
  CHECK(catalogue.torque(115) == Approx(-250));  // the last line continues
  CHECK(catalogue.no_load_speed() == Approx(102.5));
  CHECK(catalogue.torque(catalogue.no_load_speed()) == Approx(0).margin(1e-12));
}

TEST_CASE("Two cages meet the name plate: rated, starting and pull-out torque", "[mbd][motor]") {
  const DoubleCageMotor motor = solve_cages({.rated_power = 450e3,
                                             .synchronous_speed = 600 * rpm,
                                             .rated_slip = 0.0167,
                                             .breakdown_ratio = 2.5,
                                             .starting_ratio = 1.8});
  const double rated = motor.rated_torque(), synchronous = motor.synchronous_speed;
  CHECK(rated * motor.rated_speed() == Approx(450e3));
  CHECK(motor.torque(motor.rated_speed()) == Approx(rated).epsilon(1e-9));
  CHECK(motor.torque(0) == Approx(1.8 * rated).epsilon(1e-9));
  CHECK(motor.torque(synchronous) == 0);
  double largest = 0;
  for (int k = 0; k <= 10000; ++k) largest = std::max(largest, motor.torque(synchronous * k / 10000));
  CHECK(largest == Approx(2.5 * rated).epsilon(1e-6));
  CHECK(motor.torque(1.01 * synchronous) < 0);
  CHECK(motor.current(motor.rated_speed()) == Approx(1));
  CHECK(motor.current(0) > 4.5);  // locked rotor
  CHECK(motor.current(0) < 7.5);
}

TEST_CASE("Motors by NEMA letter have starting and pull-out torques inside their bands", "[mbd][motor]") {
  struct Band {
    NemaDesign design;
    double start_low, start_high, pull_low, pull_high, slip_low, slip_high;
  };
  const auto band = GENERATE(values<Band>({{NemaDesign::a, 0.7, 2.75, 1.75, 3.0, 0.005, 0.05},
                                           {NemaDesign::b, 0.7, 2.75, 1.75, 3.0, 0.005, 0.05},
                                           {NemaDesign::c, 2.0, 2.5, 1.9, 2.5, 0.01, 0.05},
                                           {NemaDesign::d, 2.7, 2.8, 2.7, 2.8, 0.05, 0.08}}));
  const DoubleCageMotor motor = nema_motor(band.design, 450e3, 600 * rpm);
  const double rated = motor.rated_torque();
  CHECK(motor.torque((1 - motor.rated_slip) * 600 * rpm) == Approx(rated).epsilon(1e-9));
  CHECK(motor.rated_slip >= band.slip_low);
  CHECK(motor.rated_slip <= band.slip_high);
  CHECK(motor.torque(0) / rated >= band.start_low);
  CHECK(motor.torque(0) / rated <= band.start_high);
  double largest = 0;
  for (int k = 0; k <= 1000; ++k) largest = std::max(largest, motor.torque(600 * rpm * k / 1000) / rated);
  CHECK(largest >= band.pull_low);
  CHECK(largest <= band.pull_high);
}

TEST_CASE("A name plate that no pair of cages can meet is refused", "[mbd][motor]") {
  CHECK_THROWS_AS(solve_cages({1e3, 100, 0.02, 2.0, 9.0}), BadInput);
  CHECK_THROWS_AS(solve_cages({1e3, 100, 0.3, 1.2, 0.1}), BadInput);
}

TEST_CASE("Rotor current: its losses are torque x slip", "[mbd][motor]") {
  // I^2 R = T s w0 for a cage of constant resistance: (I/IN)^2 = T s / (TN sN).
  const InductionMotor motor = induction_450kw();
  for (const double slip : {0.005, 0.0167, 0.08, 0.5, 1.0}) {
    const double speed = (1 - slip) * 600 * rpm;
    const double expected = motor.torque(speed) * slip / (motor.rated_torque() * 0.0167);
    CHECK(std::pow(motor_current(Motor{motor}, speed, 1, 0), 2) == Approx(expected).epsilon(1e-12));
  }
  CHECK(motor_current(Motor{paper_droop()}, 0, 1, 5e3) == Approx(paper_droop().stall_torque / 5e3));
}

TEST_CASE("Run-up on a table of torques: the integral of J dw / T, piece by piece", "[mbd][motor]") {
  // Straight pieces: J (w2 - w1) / (T2 - T1) ln(T2 / T1).
  const double inertia = 300;
  double exact = 0;
  const double target = 97;  // short of the speed of zero torque
  for (std::size_t k = 0; k + 1 < catalogue.speeds.size() && catalogue.speeds[k] < target; ++k) {
    const double w1 = catalogue.speeds[k], w2 = std::min(catalogue.speeds[k + 1], target);
    const double t1 = catalogue.torque(w1), t2 = catalogue.torque(w2);
    exact += inertia * (w2 - w1) / (t2 - t1) * std::log(t2 / t1);
  }
  Drivetrain drivetrain({.motor = catalogue, .eccentric_inertia = inertia, .start = DrivetrainStart::rest});
  run(drivetrain, exact, GENERATE(1, 10, 1000), no_rock);
  CHECK(drivetrain.state().speed == Approx(target).epsilon(1e-7));
}

TEST_CASE("Each motor law has its own name and parameters", "[mbd][motor]") {
  const std::vector<std::string> models = motor_models();
  CHECK(models.size() == std::variant_size_v<Motor>);
  for (const std::string& model : models) {
    Motor motor = motor_of_model(model);
    CHECK(model_of(motor) == model);
    CHECK(std::ranges::count(models, model) == 1);
    std::vector<std::string> keys;
    for_each_parameter([&](const char* key, const char*, auto&, const char*) { keys.emplace_back(key); }, motor);
    CHECK_FALSE(keys.empty());
    for (const std::string& key : keys) CHECK(std::ranges::count(keys, key) == 1);
  }
  CHECK_THROWS_WITH(motor_of_model("steam"), Catch::Matchers::StartsWith("unknown motor model `steam`; use one of"));
}

TEST_CASE("Torques are proportional to the voltage squared, and a droop line is shifted", "[mbd][motor]") {
  const double voltage = 0.8;
  for (const double speed : {0.0, 30.0, 55.0}) {
    CHECK(motor_torque(catalogue, speed, voltage) == Approx(0.64 * catalogue.torque(speed)));
    CHECK(motor_torque(induction_450kw(), speed, voltage) == Approx(0.64 * induction_450kw().torque(speed)));
    const DroopMotor droop = paper_droop();
    CHECK(motor_torque(droop, speed, voltage) == Approx(droop.torque(speed) - 0.2 * droop.stall_torque));
    CHECK(motor_torque(ConstantSpeedMotor{60}, speed, voltage) == 0);
  }
}

TEST_CASE("Motors out of range are refused", "[mbd][motor]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_NOTHROW(check_motor(catalogue));
  CHECK_NOTHROW(check_motor(induction_450kw()));
  InductionMotor motor = induction_450kw();
  motor.breakdown_ratio = 1;
  CHECK_THROWS_AS(check_motor(motor), BadInput);
  motor = induction_450kw();
  motor.rated_slip = 1;
  CHECK_THROWS_AS(check_motor(motor), BadInput);
  motor.rated_slip = nan;
  CHECK_THROWS_AS(check_motor(motor), BadInput);
  CHECK_THROWS_AS(check_motor(DroopMotor{.synchronous_speed = 60, .stall_torque = 0}), BadInput);
  CHECK_THROWS_AS(check_motor(ConstantSpeedMotor{.speed = -1}), BadInput);
  CHECK_THROWS_AS(check_motor(CurveMotor{{0}, {1}}), BadInput);
  CHECK_THROWS_AS(check_motor(CurveMotor{{0, 1}, {1}}), BadInput);
  CHECK_THROWS_AS(check_motor(CurveMotor{{0, 5, 5}, {2, 1, 0}}), BadInput);
  CHECK_THROWS_AS(check_motor(CurveMotor{{1, 5}, {2, 0}}), BadInput);    // no standstill
  CHECK_THROWS_AS(check_motor(CurveMotor{{0, 5}, {2, 1}}), BadInput);    // never zero
  CHECK_THROWS_AS(check_motor(CurveMotor{{0, 5}, {-1, -2}}), BadInput);  // never drives
  CHECK_THROWS_AS(check_motor(CurveMotor{{-5, 5}, {2, -8}}), BadInput);  // idles backwards
}

}  // namespace gyro
