// SPDX-License-Identifier: GPL-3.0-or-later
// A drivetrain FMU of another program in the loop: without saved state and without sums, in other units, and its
// failures.
#include "tests/io/fmu/foreign.hpp"
#include "app/verify/fixtures/drives.hpp"
#include "core/base/errors.hpp"
#include "io/fmu/drive_fmu.hpp"
#include "mbd/drivetrain.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <cfenv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <thread>

namespace {

using namespace gyro;
using namespace gyro::fixtures;
using Catch::Matchers::Contains;

DriveFmu foreign(const std::filesystem::path& file) {
  write_foreign_fmu(file);
  const ModelDescription model = read_fmu(file);
  DriveFmu fmu = unconnected(file, model);
  const auto connect = [&](FmuQuantity quantity, const char* name) {
    fmu.links[static_cast<std::size_t>(quantity)] = link_to(model, quantity, name);
  };
  connect(FmuQuantity::mantle_torque, "T_load");
  connect(FmuQuantity::eccentric_speed, "shaft.w");
  connect(FmuQuantity::motor_torque, "tau");
  return fmu;
}

/// The built-in machine with the same equation.
DrivetrainParameters same_machine() {
  return {.motor = DroopMotor{452.5 * rpm, 23.4375}, .gear_ratio = 1, .eccentric_inertia = 0.174};
}

double rock(double, double angle) {
  return 6 * (1 + std::sin(7 * angle));
}

}  // namespace

TEST_CASE("A foreign drivetrain without saved state follows the built-in one with the same equation") {
  const ScratchDirectory place;
  Drivetrain built_in(same_machine()),
      other(open_drive(foreign(place.path() / "foreign.fmu")), {.residual_limit = 0.02});
  CHECK(other.state().speed == Approx(452.5 * rpm).epsilon(1e-14));
  double slowest = 1e9;
  for (int k = 0; k < 2000; ++k) {
    const Window window = window_number(k, 0.5e-3);
    exchange(built_in, window, rock);
    exchange(other, window, rock);
    REQUIRE(other.state().speed == Approx(built_in.state().speed).epsilon(1e-4));  // Euler's error at 50 us
    // The wall is predicted with the last acceleration, which is unknown in the first window.
    if (k > 0) REQUIRE(std::abs(other.state().wall_angle - other.state().angle) < 2e-6);
    slowest = std::min(slowest, other.state().speed);
  }
  CHECK(slowest < 400 * rpm);
  CHECK(other.state().angle == Approx(built_in.state().angle).epsilon(1e-4));
  CHECK(std::isnan(other.means().power_residual));  // the FMU does not output its work
  CHECK(other.window_divisor() == 1);
  CHECK(other.knows().motor_torque);
  CHECK(!other.knows().motor_power);
  CHECK_THAT(other.unsaveable(), Contains("cannot save its state") && Contains("canGetAndSetFMUstate is false"));
}

TEST_CASE("A foreign drivetrain with an output for the motor's angle but not for its speed has no motor speed") {
  FmuLinks links{};
  links[static_cast<std::size_t>(FmuQuantity::motor_angle)] = FmuLink{};
  links[static_cast<std::size_t>(FmuQuantity::motor_torque)] = FmuLink{};
  CHECK(!knowledge_of(links).motor_speed);
  CHECK(knowledge_of(links).motor_power);  // torque x increase of the angle
  links[static_cast<std::size_t>(FmuQuantity::motor_speed)] = FmuLink{};
  CHECK(knowledge_of(links).motor_speed);
}

TEST_CASE("A foreign drivetrain that the rock stops is reported as stalled") {
  const ScratchDirectory place;
  Drivetrain drive(open_drive(foreign(place.path() / "foreign.fmu")), {});
  for (int k = 0; k < 4000 && !drive.stalled(); ++k)
    exchange(drive, window_number(k, 0.5e-3), [](double, double) { return 60.0; });
  REQUIRE(drive.stalled());
  CHECK(drive.events().front().kind == DriveEventKind::stall);
  // J dw/dt = 23.4375 (1 - w / w0) - 60 comes to rest after J w0 / 23.4375 ln(60 / 36.5625)
  CHECK(*drive.stall_time() == Approx(0.174 * 452.5 * rpm / 23.4375 * std::log(60 / 36.5625)).margin(1e-3));
}

TEST_CASE("A failure of a foreign drivetrain stops the run with the FMU's own message") {
  const ScratchDirectory place;
  DriveFmu fmu = foreign(place.path() / "foreign.fmu");
  const ModelDescription model = read_fmu(fmu.file);
  const auto run = [&] {
    Drivetrain drive(open_drive(fmu), {});
    for (int k = 0; k < 100; ++k) exchange(drive, window_number(k, 0.5e-3), rock);
  };
  CHECK_NOTHROW(run());
  fmu.starts = {start_of(model, "fail_at", 0.01)};
  CHECK_THROWS_WITH(run(), Contains("foreign.fmu failed at t = 0.01") && Contains("fmi2DoStep returned fmi2Error") &&
                               Contains("the motor is on fire"));
  CHECK_THROWS_AS(run(), StoppedByGuard);
  fmu.starts = {start_of(model, "blind_at", 0.01)};
  CHECK_THROWS_WITH(run(), Contains("not finite"));
  CHECK_THROWS_AS(run(), StoppedByGuard);
  fmu.guid = "another";
  CHECK_THROWS_WITH(run(), Contains("cannot be instantiated: the GUID is another"));
  CHECK_THROWS_AS(run(), BadInput);
}

TEST_CASE("An FMU that exits, throws or crashes ends only its own process, and the run stops with the reason") {
  const ScratchDirectory place;
  DriveFmu fmu = foreign(place.path() / "foreign.fmu");
  const ModelDescription model = read_fmu(fmu.file);
  const auto [misdeed, reason] = GENERATE(table<double, std::string>(
      {{1, "ended its process with exit code 0"}, {2, "threw an exception: of the FMU"}, {3, "signal 11"}}));
  fmu.starts = {start_of(model, "misdeed", misdeed), start_of(model, "misdeed_at", 0.01)};
  Drivetrain drive(open_drive(fmu), {});
  const auto run = [&] {
    for (int k = 0; k < 100; ++k) exchange(drive, window_number(k, 0.5e-3), rock);
  };
  CHECK_THROWS_WITH(run(), Contains("the drivetrain FMU foreign.fmu") && Contains(reason));
  if (misdeed != 2) CHECK_THROWS_WITH(run(), Contains("has ended"));
}

TEST_CASE("The time limit of a call does not apply to the time before the first step of an FMU") {
  const ScratchDirectory place;
  const DriveFmu fmu = foreign(place.path() / "foreign.fmu");
  const auto drive = open_drive(fmu, std::chrono::milliseconds(100));  // its process would end itself after 5.1 s
  std::this_thread::sleep_for(std::chrono::milliseconds(6500));
  ShaftMotion motion = drive->start();
  CHECK_NOTHROW(drive->advance(1e-3, {}, motion));
}

TEST_CASE("An FMU that does not answer in time stops the run") {
  const ScratchDirectory place;
  DriveFmu fmu = foreign(place.path() / "foreign.fmu");
  const ModelDescription model = read_fmu(fmu.file);
  fmu.starts = {start_of(model, "misdeed", 4)};
  const auto drive = open_drive(fmu, std::chrono::milliseconds(200));
  ShaftMotion motion = drive->start();
  CHECK_THROWS_WITH(drive->advance(1e-3, {}, motion), Contains("has not answered for 0.2 s"));
}

TEST_CASE("An FMU that changes the rounding mode does not change ours") {
  const ScratchDirectory place;
  DriveFmu fmu = foreign(place.path() / "foreign.fmu");
  const ModelDescription model = read_fmu(fmu.file);
  fmu.starts = {start_of(model, "misdeed", 5)};
  const auto drive = open_drive(fmu);
  ShaftMotion motion = drive->start();
  drive->advance(1e-3, {}, motion);
  CHECK(std::fegetround() == FE_TONEAREST);
}

TEST_CASE("A library that was cut off is refused") {
  const ScratchDirectory place;
  std::ifstream whole(GYRO_FOREIGN_FMU, std::ios::binary);
  std::string content{std::istreambuf_iterator<char>(whole), {}};
  const auto cut = place.path() / "cut.so";
  std::ofstream(cut, std::ios::binary) << content.substr(0, content.size() / 2);
  const auto file = place.path() / "foreign.fmu";
  write_foreign_fmu(file, foreign_description(), "binaries/linux64/flywheel.so", cut.c_str());
  DriveFmu fmu;
  fmu.file = file;
  fmu.identifier = "flywheel";
  CHECK_THROWS_AS(open_drive(fmu), BadInput);
}

TEST_CASE("A foreign drivetrain reports trips by a boolean output") {
  const ScratchDirectory place;
  DriveFmu fmu = foreign(place.path() / "foreign.fmu");
  const ModelDescription model = read_fmu(fmu.file);
  CHECK(!history_of(model));
  CHECK_THROWS_WITH(link_to(model, FmuQuantity::tripped, "tau"),
                    Contains("\"tau\" is not a boolean output (Real, output); boolean outputs of the FMU are off"));
  fmu.links[static_cast<std::size_t>(FmuQuantity::tripped)] = link_to(model, FmuQuantity::tripped, "off");
  fmu.starts = {start_of(model, "trip_at", 0.0101)};
  const auto drive = open_drive(fmu);
  ShaftMotion motion = drive->start();
  std::vector<DriveEvent> events;
  const auto go_on = [&](double torque) {
    for (const DriveEvent& event : drive->advance(1e-3, {.rock_torque = torque}, motion).events)
      events.push_back(event);
  };
  for (int k = 0; k < 20; ++k) go_on(1);
  REQUIRE(events.size() == 1);
  CHECK(events[0].kind == DriveEventKind::trip);
  CHECK(to_string(events[0].kind) == "trip");
  CHECK(events[0].time == Approx(0.011));  // at the end of the step
  while (motion.speed > 0) go_on(500);
  REQUIRE(events.size() == 2);
  CHECK(events[1].kind == DriveEventKind::standstill);  // not a stall, because the motor is off
}

TEST_CASE("A library with undefined symbols is refused with a way to provide them") {
  const ScratchDirectory place;
  const auto file = place.path() / "foreign.fmu";
  write_foreign_fmu(file, foreign_description(), "binaries/linux64/flywheel.so", GYRO_ORPHAN_FMU);
  DriveFmu fmu;
  fmu.file = file;
  fmu.identifier = "flywheel";
  CHECK_THROWS_WITH(open_drive(fmu), Contains("undefined symbol") && Contains("LD_PRELOAD"));
}
