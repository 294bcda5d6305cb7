// SPDX-License-Identifier: GPL-3.0-or-later
// Drivetrains as FMUs through the program: exported, used in a run, refused.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"
#include "tests/io/fmu/foreign.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

const std::string crush_case = "'" GYRO_APP_CASES "/crush.yaml' ";
const std::string losses = "--set 'drivetrain.losses={no_load: 20 W, load_factor: 0.05}' ";
const std::string crush = "run " + crush_case + "--set output.snapshots=0 ";

/// Complete drivetrains that replace the one of the case.
std::string with_drive(const std::string& keys) {
  return "--set 'drivetrain={" + keys + "}' ";
}

/// The foreign machine with the case's equation.
std::string with_foreign(const Workplace& place, const std::string& more = "") {
  return with_drive("fmu: \"" + (place.path() / "foreign.fmu").string() +
                    "\", map: {mantle_torque: T_load, eccentric_speed: shaft.w, motor_torque: tau}" + more);
}

void require_close(const fs::path& a, const fs::path& b, double tolerance) {
  const auto one = all_results(a), other = all_results(b);
  REQUIRE(one.size() == other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    INFO(one[k].first);
    REQUIRE(one[k].first == other[k].first);
    REQUIRE(one[k].second.size() == other[k].second.size());
    double largest = 0, apart = 0;
    for (std::size_t i = 0; i < one[k].second.size(); ++i) {
      largest = std::max(largest, std::abs(one[k].second[i]));
      apart = std::max(apart, std::abs(one[k].second[i] - other[k].second[i]));
    }
    // The power residual consists of the rounding errors of the motor's power.
    CHECK(apart <= tolerance * (one[k].first == "ledger/power_residual" ? 1e3 : largest));
  }
}

}  // namespace

TEST_CASE("A run with the exported FMU has the numbers of the built-in drivetrain, also in parts") {
  const Workplace place;
  const Outcome made = place.gyrosim("export fmu " + crush_case + losses + "--out drive.fmu");
  INFO(made.err);
  REQUIRE(made.code == 0);
  CHECK_THAT(made.out, Contains("drive.fmu: FMI 2.0 co-simulation") && Contains("fmu: drive.fmu"));
  const std::string fmu = with_drive("fmu: \"" + (place.path() / "drive.fmu").string() + "\"");
  REQUIRE(place.gyrosim(crush + losses + "--until '20 ms' --out built-in").code == 0);
  REQUIRE(place.gyrosim(crush + fmu + "--until '20 ms' --out whole").code == 0);
  CHECK(summary_of(place.path() / "whole")["bonds_broken"] > 3);
  CHECK(result_of(place.path() / "whole", "series/motor_torque").back() > 0.05);
  require_close(place.path() / "built-in", place.path() / "whole", 1e-9);

  REQUIRE(place.gyrosim(crush + fmu + "--until '8.5 ms' --out parts").code == 0);
  const Outcome rest = place.gyrosim(crush + fmu + "--until '20 ms' --out parts --resume");
  INFO(rest.err);
  REQUIRE(rest.code == 0);
  const auto whole = all_results(place.path() / "whole"), parts = all_results(place.path() / "parts");
  CHECK(whole == parts);
  const std::string log = read_text(place.path() / "whole/log.txt");
  CHECK_THAT(log, Contains("the drivetrain is native code of") && Contains("drive.fmu") && !Contains("no checkpoints"));

  // The same FMU from the directory of the run.
  REQUIRE(place.gyrosim("export fmu built-in --out again.fmu").code == 0);
  CHECK(read_text(place.path() / "again.fmu") == read_text(place.path() / "drive.fmu"));
}

TEST_CASE("A relay of the exported FMU trips as that of the built-in drivetrain, and the summary reports it") {
  const Workplace place;
  const std::string relay =
      "--set drivetrain.inertia.eccentric='0.01 kg m2' --set 'drivetrain.protection={instantaneous_ratio: 0.2, "
      "rated_torque: 0.1 N m, brake_torque: 25 N m}' ";
  REQUIRE(place.gyrosim("export fmu " + crush_case + relay + "--out drive.fmu").code == 0);
  const std::string fmu = with_drive("fmu: \"" + (place.path() / "drive.fmu").string() + "\"");
  REQUIRE(place.gyrosim(crush + relay + "--until '40 ms' --out built-in").code == 0);
  REQUIRE(place.gyrosim(crush + fmu + "--until '19 ms' --out fmu").code == 0);
  const Outcome rest = place.gyrosim(crush + fmu + "--until '40 ms' --out fmu --resume");
  INFO(rest.err);
  REQUIRE(rest.code == 0);
  require_close(place.path() / "built-in", place.path() / "fmu", 1e-9);
  const nlohmann::json ours = summary_of(place.path() / "built-in"), theirs = summary_of(place.path() / "fmu");
  REQUIRE(ours["drive_events"].size() == 2);
  CHECK(ours["drive_events"][0]["event"] == "instantaneous trip");
  CHECK(ours["drive_events"][1]["event"] == "standstill");
  REQUIRE(theirs["drive_events"].size() == 2);
  for (const std::size_t k : {0, 1}) {
    CHECK(theirs["drive_events"][k]["event"] == ours["drive_events"][k]["event"]);
    CHECK(theirs["drive_events"][k]["time"].get<double>() ==
          Approx(ours["drive_events"][k]["time"].get<double>()).epsilon(1e-9));
  }
  CHECK(theirs["stalled"] == ours["stalled"]);
}

TEST_CASE("A foreign FMU turns the crusher, without checkpoints when it cannot save itself") {
  const Workplace place;
  write_foreign_fmu(place.path() / "foreign.fmu",
                    replaced(foreign_description(), "canHandle", "needsExecutionTool=\"true\" canHandle"));
  const Outcome run = place.gyrosim(crush + with_foreign(place) + "--until '5 ms' --out r");
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(run.err.find("native code") != std::string::npos);
  CHECK_THAT(read_text(place.path() / "r/log.txt"),
             Contains("native code") && Contains("another program") &&
                 Contains("foreign.fmu declares that it needs another program") &&
                 Contains("this run has no checkpoints") && Contains("canGetAndSetFMUstate is false"));
  CHECK(!fs::exists(place.path() / "r/checkpoint.h5"));
  const std::vector<std::string> series = results_in(place.path() / "r", "series");
  const auto there = [&](const char* name) { return std::ranges::find(series, name) != series.end(); };
  CHECK(there("eccentric_angle"));
  CHECK(there("motor_torque"));
  CHECK(!there("motor_power"));  // the FMU does not give it
  CHECK(result_of(place.path() / "r", "series/eccentric_speed").front() == Approx(47.39).epsilon(1e-3));
  const Outcome later = place.gyrosim(crush + with_foreign(place) + "--until '6 ms' --out r --resume");
  CHECK(later.code == 2);
  CHECK_THAT(later.err, Contains("checkpoint.h5"));
}

TEST_CASE("A foreign FMU that fails stops the run with its reason") {
  const Workplace place;
  write_foreign_fmu(place.path() / "foreign.fmu");
  const Outcome run =
      place.gyrosim(crush + with_foreign(place, ", parameters: {fail_at: 0.003}") + "--until '10 ms' --out r");
  CHECK(run.code == 4);
  const nlohmann::json summary = summary_of(place.path() / "r");
  CHECK(summary["status"] == "stopped");
  CHECK_THAT(summary["reason"].get<std::string>(), Contains("foreign.fmu failed at t = 0.003") && Contains("on fire"));
  CHECK(result_of(place.path() / "r", "series/time").back() == Approx(0.003));
}

TEST_CASE("An FMU that calls exit(0) stops the run, which still writes its checkpoint and its summary") {
  const Workplace place;
  write_foreign_fmu(place.path() / "foreign.fmu");
  const Outcome run = place.gyrosim(crush + with_foreign(place, ", parameters: {misdeed: 1, misdeed_at: 0.003}") +
                                    "--until '10 ms' --out r");
  CHECK(run.code == 4);
  CHECK_THAT(run.err, Contains("ended its process with exit code 0"));
  CHECK(summary_of(place.path() / "r")["status"] == "stopped");
  CHECK(result_of(place.path() / "r", "series/time").back() == Approx(0.003));
}

TEST_CASE("The check of a case warns before it starts native code") {
  const Workplace place;
  write_foreign_fmu(place.path() / "foreign.fmu");
  CHECK_THAT(place.gyrosim("check " + crush_case + with_foreign(place)).err,
             Contains("starts the native code of") && Contains("foreign.fmu"));
  CHECK(place.gyrosim("check " + crush_case).err.empty());
}

TEST_CASE("An FMU that cannot be used is refused with its place in the case before any file is written") {
  const Workplace place;
  const auto refused = [&](const std::string& set) {
    const Outcome run = place.gyrosim(crush + set + "--out r");
    CHECK(run.code == 2);
    CHECK(!fs::exists(place.path() / "r"));
    return run.err;
  };
  write_foreign_fmu(place.path() / "foreign.fmu");
  CHECK_THAT(refused(with_foreign(place, ", parameters: {J: 0.2, K: 1}")),
             Contains("--set:2:") && Contains("no parameter \"K\"; parameters of the FMU are J, fail_at"));
  CHECK_THAT(refused(with_drive("fmu: \"" + (place.path() / "foreign.fmu").string() + "\"")),
             Contains("no variable \"mantle_torque\"") && Contains("no variable \"eccentric_speed\"") &&
                 Contains("outputs of the FMU are shaft.w, tau"));
  write_foreign_fmu(place.path() / "foreign.fmu", replaced(foreign_description(), "foreign-1", "foreign-2"));
  CHECK_THAT(refused(with_foreign(place)), Contains("--set:2:") && Contains("the GUID is foreign-2, not foreign-1"));
  write_archive(place.path() / "foreign.fmu", {{"modelDescription.xml", foreign_description()}, {"../escape", "x"}});
  CHECK_THAT(refused(with_foreign(place)), Contains("\"../escape\" leaves the archive's folder"));
  write_archive(place.path() / "foreign.fmu",
                {{"modelDescription.xml", foreign_description()}, {"binaries/linux64/flywheel.so", "no library"}});
  CHECK_THAT(refused(with_foreign(place)), Contains("its library cannot be loaded"));
}

TEST_CASE("Cases without a motor have no FMU") {
  const Workplace place;
  const Outcome box = place.gyrosim("export fmu '" GYRO_CASES "/box.yaml'");
  CHECK(box.code == 2);
  CHECK_THAT(box.err, Contains("has no drivetrain; export one"));
  write_foreign_fmu(place.path() / "foreign.fmu");
  const Outcome again = place.gyrosim("export fmu " + crush_case + with_foreign(place));
  CHECK(again.code == 2);
  CHECK_THAT(again.err, Contains("its drivetrain is an FMU already"));
  const Outcome unwritable = place.gyrosim("export fmu " + crush_case + "--out no/such/folder/x.fmu");
  CHECK(unwritable.code == 5);
  CHECK(place.listing() == std::vector<std::string>{"foreign.fmu"});
}
