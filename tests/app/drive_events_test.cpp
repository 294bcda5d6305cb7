// SPDX-License-Identifier: GPL-3.0-or-later
// Runs in which rock stops the drive or a relay trips: motion, accounts, summary, resumption.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>

namespace {

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

const std::string crush = "run '" GYRO_APP_CASES "/crush.yaml' --quiet --set output.snapshots=0 ";

/// Rock that does not break, and a weak drive with little inertia.
const std::string jam = crush +
                        "--set bonds.tensile_strength='450 MPa' --set bonds.shear_strength='300 MPa' "
                        "--set drivetrain.motor.stall_torque='1 N m' --set drivetrain.losses.load_factor=0.3 "
                        "--set 'drivetrain.inertia={motor: 4e-5 kg m2, eccentric: 4e-4 kg m2}' ";

struct Happening {
  std::string what;
  double time;
};

std::vector<Happening> happenings(const fs::path& run) {
  std::vector<Happening> all;
  const nlohmann::json summary = summary_of(run);
  for (const auto& event : summary["drive_events"]) all.push_back({event["event"], event["time"]});
  return all;
}

/// Largest |value| of a series in rows completely after a time; -1 if there is none.
double largest_after(const fs::path& run, const std::string& series, double time) {
  const std::vector<double> end = result_of(run, "series/time"), value = result_of(run, "series/" + series);
  double largest = -1;
  for (std::size_t k = 1; k < end.size(); ++k)
    if (end[k - 1] > time) largest = std::max(largest, std::abs(value[k]));
  return largest;
}

/// |motor work - losses - crushing work - gain of kinetic energy| from the start to each row, by the series: powers are
/// means over the rows, speeds are taken at their ends.
struct Account {
  double largest_missing, exchanged;
};
Account account(const fs::path& run, double inertia, double start_speed) {
  const std::vector<double> time = result_of(run, "series/time"), motor = result_of(run, "series/motor_power"),
                            loss = result_of(run, "series/loss_power"),
                            crushing = result_of(run, "series/crushing_power"),
                            speed = result_of(run, "series/eccentric_speed");
  Account a{0, 0};
  double work = 0, before = 0;
  for (std::size_t k = 0; k < time.size(); ++k) {
    const double length = time[k] - before;
    work += (motor[k] - loss[k] - crushing[k]) * length;
    a.exchanged += std::abs(crushing[k]) * length;
    const double gain = 0.5 * inertia * (speed[k] * speed[k] - start_speed * start_speed);
    a.largest_missing = std::max(a.largest_missing, std::abs(work - gain));
    before = time[k];
  }
  return a;
}

constexpr double idle = 1697.0 / 60 * 2 * 3.14159265358979323846 / 3.75;  // [rad/s]

}  // namespace

TEST_CASE("A relay trips under rock: the machine coasts or is braked to a halt, and the summary reports it") {
  const double brake = GENERATE(0.0, 25.0);  // at the motor [N m]
  const Workplace place;
  const Outcome outcome =
      place.gyrosim(crush + "--until '40 ms' --out r --set drivetrain.inertia.eccentric='0.01 kg m2' --set " +
                    "'drivetrain.protection={instantaneous_ratio: 0.2, rated_torque: 0.1 N m, brake_torque: " +
                    std::to_string(brake) + " N m}'");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const fs::path run = place.path() / "r";
  const std::vector<Happening> events = happenings(run);
  REQUIRE(events.size() == (brake > 0 ? 2 : 1));
  const double trip = events[0].time;
  CHECK(events[0].what == "instantaneous trip");
  CHECK(trip > 0.01);  // not before rock is crushed
  CHECK(trip < 0.03);
  const double maximum = result_of(run, "series/motor_torque")[static_cast<std::size_t>(trip / 0.5e-3) - 1];
  CHECK(maximum > 0);
  CHECK(maximum < 0.02);  // torque that the relay does not detect [N m]
  CHECK(largest_after(run, "motor_torque", trip) == 0);
  CHECK(largest_after(run, "motor_power", trip) == 0);
  const nlohmann::json summary = summary_of(run);
  CHECK(summary["status"] == "done");
  CHECK(summary["stalled"] == false);  // it was switched off
  CHECK_THAT(outcome.err, Contains("drive: instantaneous trip at t = 0.01"));
  CHECK_THAT(read_text(run / "log.txt"), Contains("drive: instantaneous trip at t = 0.01"));

  const double inertia = 0.01 + 3.75 * 3.75 * 1.526e-3;
  CHECK(account(run, inertia, idle).largest_missing < 1e-3 * 0.5 * inertia * idle * idle);
  if (brake == 0) {
    CHECK(result_of(run, "series/eccentric_speed").back() > 0.9 * idle);
    CHECK(largest_after(run, "loss_power", trip) == 0);
    return;
  }
  CHECK(events[1].what == "standstill");
  // The rock's torque is a few per cent of the brake's.
  CHECK(events[1].time - trip == Approx(inertia * idle / (3.75 * brake)).epsilon(0.05));
  CHECK(largest_after(run, "eccentric_speed", events[1].time) == 0);
  const std::vector<double> angle = result_of(run, "series/eccentric_angle");
  CHECK(angle[angle.size() - 1] == angle[angle.size() - 10]);
}

TEST_CASE("Rock that does not break stalls the drive for good, and a resumed run has the same stall") {
  const Workplace place;
  const std::string run = jam +
                          "--set 'drivetrain.protection={under_speed: 0.3, under_speed_delay: 30 ms, "
                          "brake_torque: 5 N m}' ";
  const Outcome outcome = place.gyrosim(run + "--until '70 ms' --out whole");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const fs::path whole = place.path() / "whole";
  CHECK(summary_of(whole)["status"] == "done");
  CHECK(summary_of(whole)["stalled"] == true);
  const std::vector<Happening> events = happenings(whole);
  REQUIRE(events.size() == 2);  // no chatter: it stops once
  CHECK(events[0].what == "stall");
  CHECK(events[1].what == "under-speed trip");
  const double stall = events[0].time, trip = events[1].time;
  CHECK(trip > stall + 0.01);
  CHECK(trip < stall + 0.03);

  CHECK(largest_after(whole, "eccentric_speed", stall) == 0);
  CHECK(largest_after(whole, "motor_power", stall) == 0);
  CHECK(largest_after(whole, "crushing_power", stall + 1e-3) == 0);  // the wall follows a window later
  CHECK(largest_after(whole, "motor_torque", trip) == 0);
  const auto row = [](double time) { return static_cast<std::size_t>(time / 0.5e-3); };
  CHECK(result_of(whole, "series/motor_torque")[row(trip) - 1] == Approx(1));  // until then it pushes
  const std::vector<double> angle = result_of(whole, "series/eccentric_angle");
  CHECK(angle.back() == angle[row(stall) + 1]);
  const double inertia = 4e-4 + 3.75 * 3.75 * 4e-5;
  const Account a = account(whole, inertia, idle);
  REQUIRE(a.exchanged > 0.3);
  CHECK(a.largest_missing < 1e-3 * a.exchanged);

  for (const double end : {stall - 2e-3, (stall + trip) / 2, 0.07})
    REQUIRE(place.gyrosim(run + "--out parts --resume --until " + std::to_string(end)).code == 0);
  const fs::path parts = place.path() / "parts";
  CHECK(summary_of(parts)["drive_events"] == summary_of(whole)["drive_events"]);
  CHECK(all_results(parts) == all_results(whole));
}
