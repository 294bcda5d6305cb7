// SPDX-License-Identifier: GPL-3.0-or-later
// Compares the exported drivetrain, run by our own master, with the built-in drivetrain.
#include "app/verify/fixtures/drives.hpp"
#include "core/base/errors.hpp"
#include "io/fmu/drive_fmu.hpp"
#include "io/fmu/export.hpp"
#include "mbd/drivetrain.hpp"
#include "mbd/shaft.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <cmath>

namespace {

using namespace gyro;
using namespace gyro::fixtures;
using Catch::Matchers::Contains;

/// A drive with all optional parts: two cages, mantle spin, bearings, spring, a sagging supply voltage, relays that
/// trip.
DrivetrainParameters full_machine() {
  DrivetrainParameters p = crusher_62_75(nema_motor(NemaDesign::c, 450e3, 600 * rpm));
  p.losses = {60e3, 0.02, 300};
  p.gear_efficiency = 0.97;
  p.start_angle = 0.3;
  p.mantle_inertia = 3000;
  p.bearings = {{0.005, 0.7, 2e5}, {0.005, 0.4, 2e5}, {0.01, 0.3, 1e5}, 3.1, 0.005};
  p.spring = {2e6, 2000};
  p.voltage = {{0, 0.2, 0.5}, {1, 0.8, 0.9}};
  p.protection = {.overload_time = 3, .instantaneous_ratio = 2.2, .brake_torque = 4e3, .restart_delay = 0.1};
  return p;
}

std::vector<DrivetrainParameters> machines() {
  DrivetrainParameters from_rest = crusher_62_75(induction_450kw()), curve = from_rest, constant = from_rest;
  from_rest.start = DrivetrainStart::rest;
  curve.motor = CurveMotor{{0, 400 * rpm, 580 * rpm, 600 * rpm}, {9e3, 1.2e4, 9e3, 0}};
  constant.motor = ConstantSpeedMotor{600 * rpm};
  return {crusher_62_75(paper_droop()), from_rest, curve, constant, full_machine()};
}

/// Exports a machine as an FMU, and connects it by the names of its variables.
DriveFmu exported(const DrivetrainParameters& parameters, const std::filesystem::path& file) {
  export_drive({.drive = parameters, .title = "A <machine> & \"more\"", .tool = "test", .library = GYRO_DRIVETRAIN_FMU},
               file);
  const ModelDescription model = read_fmu(file);
  DriveFmu fmu = unconnected(file, model);
  for (std::size_t k = 0; k < fmu_quantities; ++k) {
    const std::string name(info_of(static_cast<FmuQuantity>(k)).name);
    if (model.find(name)) fmu.links[k] = link_to(model, static_cast<FmuQuantity>(k), name);
  }
  return fmu;
}

/// Load of a rock whose torque oscillates and is very high for a short time every 0.4 s.
MantleLoad load_at(double time, const MantlePath& path, double length) {
  MantleLoad load;
  load.resisting_torque = 2e4 * (1 + std::sin(60 * time)) + (std::fmod(time, 0.4) > 0.35 ? 1.2e5 : 0);
  load.spin_torque = 300 * std::cos(40 * time);
  load.bearings = {3e6 * (1 + std::sin(60 * time)), 1e6};
  load.work = load.resisting_torque * path.speed * length - load.spin_torque * path.spin * length;
  return load;
}

/// Runs both drivetrains through the windows `first` to `last` - 1 of 0.5 ms, and calls f(built_in, fmu) after each.
template <class F>
void run_both(Drivetrain& built_in, Drivetrain& fmu, std::int64_t first, std::int64_t last, F&& f) {
  for (std::int64_t k = first; k < last; ++k) {
    const Window window = window_number(k, 0.5e-3, 10);
    for (Drivetrain* d : {&built_in, &fmu}) {
      const MantlePath path = d->predict(window);
      d->advance(window, load_at(window.begin(), path, window.length()));
    }
    f(built_in, fmu);
  }
}

void check_equal(const Drivetrain& a, const Drivetrain& b) {
  const DrivetrainState &s = a.state(), &t = b.state();
  constexpr double close = 1e-11;  // the FMU outputs sums, whose differences contain their rounding errors
  REQUIRE(t.speed == Approx(s.speed).epsilon(close).margin(close));
  REQUIRE(t.angle == Approx(s.angle).epsilon(close).margin(close));
  REQUIRE(t.wall_angle == Approx(s.wall_angle).epsilon(close).margin(close));
  REQUIRE(t.spin == Approx(s.spin).epsilon(close).margin(close));
  REQUIRE(t.spin_angle == Approx(s.spin_angle).epsilon(close).margin(close));
  REQUIRE(b.motor_speed() == Approx(a.motor_speed()).epsilon(1e-9).margin(1e-9));
  REQUIRE(b.means().motor_torque == Approx(a.means().motor_torque).epsilon(1e-9).margin(1e-6));
  REQUIRE(b.means().motor_power == Approx(a.means().motor_power).epsilon(1e-9).margin(1e-4));
  REQUIRE(b.means().loss_power == Approx(a.means().loss_power).epsilon(1e-9).margin(1e-4));
  REQUIRE(b.kinetic_energy() == Approx(a.kinetic_energy()).epsilon(1e-10).margin(1e-6));
}

}  // namespace

TEST_CASE("The parameters of every machine are written as text and read back to the bit") {
  for (const DrivetrainParameters& machine : machines()) {
    const std::string text = drive_text(machine);
    const DrivetrainParameters back = drive_from_text(text);
    CHECK(drive_text(back) == text);
    CHECK(back.motor.index() == machine.motor.index());
    CHECK(motor_torque(back.motor, 55.5) == motor_torque(machine.motor, 55.5));
  }
  CHECK_THROWS_WITH(drive_from_text("nonsense"), Contains("do not begin with"));
  std::string text = drive_text(machines()[0]);
  CHECK_THROWS_WITH(drive_from_text(text.replace(text.find("gear_ratio"), 10, "gear_ratia")), Contains("gear_ratia"));
}

TEST_CASE("The exported FMU of every machine agrees with the built-in drivetrain for one second") {
  const ScratchDirectory place;
  int number = 0;
  for (const DrivetrainParameters& machine : machines()) {
    INFO("machine " << number++);
    const DriveFmu fmu = exported(machine, place.path() / "drive.fmu");
    Drivetrain built_in(machine), foreign(open_drive(fmu), {});
    if (machine.start == DrivetrainStart::running) CHECK(foreign.idle_speed() == Approx(built_in.idle_speed()));
    check_equal(built_in, foreign);
    run_both(built_in, foreign, 0, 2000, check_equal);
    CHECK(built_in.unsaveable().empty());
    CHECK(foreign.unsaveable().empty());
    for (const std::string& note : foreign.take_notes()) INFO(note);
  }
}

TEST_CASE("The relays of an exported machine act and are reported") {
  const ScratchDirectory place;
  Drivetrain built_in(full_machine()), foreign(open_drive(exported(full_machine(), place.path() / "drive.fmu")), {});
  run_both(built_in, foreign, 0, 2000, [](const Drivetrain&, const Drivetrain&) {});
  REQUIRE(!built_in.events().empty());
  const std::vector<std::string> notes = foreign.take_notes();
  REQUIRE(notes.size() == static_cast<std::size_t>(built_in.state().events));
  CHECK_THAT(notes.front(), Contains("FMU drive.fmu: " + to_string(built_in.events().front().kind)));
  const std::vector<DriveEvent> ours = built_in.events(), told = foreign.events();
  REQUIRE(told.size() == ours.size());
  for (std::size_t k = 0; k < ours.size(); ++k) {
    CHECK(told[k].kind == ours[k].kind);
    CHECK(told[k].time == Approx(ours[k].time).epsilon(1e-9));
  }
  CHECK(foreign.stall_time().has_value() == built_in.stall_time().has_value());
}

TEST_CASE("If one step has more events than an exported machine stores, their number is reported") {
  const ScratchDirectory place;
  DrivetrainParameters machine = crusher_62_75(paper_droop());
  machine.protection = {.instantaneous_ratio = 0.05, .rated_torque = 1e4, .restart_delay = 1e-3, .restarts = 20};
  const auto drive = open_drive(exported(machine, place.path() / "drive.fmu"));
  ShaftMotion motion = drive->start();
  const ShaftAdvance turn = drive->advance(2, {.rock_torque = 2e4}, motion);
  Shaft built_in(machine);
  ShaftMotion same = built_in.start();
  const ShaftAdvance all = built_in.advance(2, {.rock_torque = 2e4}, same);
  REQUIRE(all.events.size() > 20);
  REQUIRE(turn.events.size() == 8);
  CHECK(turn.events.back().kind == all.events.back().kind);
  CHECK(turn.events.back().time == Approx(all.events.back().time).epsilon(1e-9));
  bool said = false;
  for (const std::string& note : drive->take_notes())
    said = said || note.find(std::to_string(all.events.size()) + " events in one step") != std::string::npos;
  CHECK(said);
}

TEST_CASE("A new instance of an FMU continues from the saved state with the same bits") {
  const ScratchDirectory place;
  const DriveFmu fmu = exported(full_machine(), place.path() / "drive.fmu");
  Drivetrain whole(open_drive(fmu), {}), first(open_drive(fmu), {}), second(open_drive(fmu), {});
  run_both(whole, first, 0, 700, [](const Drivetrain&, const Drivetrain&) {});
  second.restore(first.state(), first.drive_state());
  run_both(whole, second, 700, 1500, [](const Drivetrain& a, const Drivetrain& b) {
    REQUIRE(a.state().speed == b.state().speed);
    REQUIRE(a.state().angle == b.state().angle);
    REQUIRE(a.means().motor_power == b.means().motor_power);
  });
  CHECK(whole.drive_state() == second.drive_state());
  const std::vector<std::uint8_t> nonsense(40, 7);
  CHECK_THROWS_AS(second.restore(first.state(), nonsense), BadInput);
}

TEST_CASE("A master can change parameters of an exported machine, and invalid values are refused") {
  const ScratchDirectory place;
  const auto file = place.path() / "drive.fmu";
  DrivetrainParameters heavier = full_machine();
  DriveFmu fmu = exported(heavier, file);
  const ModelDescription model = read_fmu(file);
  heavier.eccentric_inertia = 9000;
  std::get<DoubleCageMotor>(heavier.motor).rated_power = 400e3;
  complete_motor(heavier.motor);
  fmu.starts = {start_of(model, "inertia.eccentric", 9000), start_of(model, "motor.rated_power", 400e3)};
  Drivetrain built_in(heavier), foreign(open_drive(fmu), {});
  run_both(built_in, foreign, 0, 300, check_equal);
  fmu.starts = {start_of(model, "gear_ratio", -1)};
  CHECK_THROWS_WITH(open_drive(fmu), Contains("gear_ratio is not > 0") && Contains("drive.fmu"));
}

TEST_CASE("An FMU refuses a wrong GUID, and the same machine gives the same GUID") {
  const ScratchDirectory place;
  DriveFmu fmu = exported(machines()[0], place.path() / "a.fmu");
  const DriveFmu again = exported(machines()[0], place.path() / "b.fmu"),
                 other = exported(machines()[1], place.path() / "c.fmu");
  CHECK(fmu.guid == again.guid);
  CHECK(fmu.guid != other.guid);
  CHECK(fmu.model_name == "A <machine> & \"more\"");
  fmu.guid = other.guid;
  CHECK_THROWS_WITH(open_drive(fmu), Contains("cannot be instantiated") && Contains("GUID"));
}
