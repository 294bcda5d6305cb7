// SPDX-License-Identifier: GPL-3.0-or-later
// Outputs of a crusher's run about its drive and its liners.
#include "io/hdf5/hdf5.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <sstream>

using namespace gyro;

namespace {

const std::string crush = "'" GYRO_APP_CASES "/crush.yaml'";

}  // namespace

TEST_CASE("Maps of the liners are in results.h5 if the case asks for them, and add up") {
  const Workplace place;
  const Outcome outcome =
      place.gyrosim("run " + crush +
                    " --until '6 ms' --out maps --set output.snapshots=0 --set "
                    "'output.liners={interval: 2 ms, rows: 8, sectors: 12, wear_coefficient: 1e-12}'");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const hdf5::File file = hdf5::File::open(place.path() / "maps/results.h5");
  CHECK(file.children("/liners") == std::vector<std::string>{"concave", "mantle"});
  for (const std::string liner : {"/liners/concave", "/liners/mantle"}) {
    CHECK(file.dataset(liner + "/time").rows() == 3);
    CHECK(file.dataset(liner + "/pressure").columns() == 96);
    CHECK(file.dataset(liner + "/heights").rows() == 9);
    CHECK(file.dataset(liner + "/azimuths").rows() == 13);
    const std::vector<double> pressure = file.dataset(liner + "/pressure").read(),
                              area = file.dataset(liner + "/area").read(), work = file.dataset(liner + "/work").read(),
                              by_triangle = file.dataset(liner + "/triangles/work").read(),
                              wear = file.dataset(liner + "/triangles/wear").read();
    double push = 0;
    for (std::size_t k = 0; k < pressure.size(); ++k) push += pressure[k] * area[k % 96] / 3;
    CHECK(push > 0);  // mean normal force [N]
    CHECK(push < 1e5);
    const auto sum = [](const std::vector<double>& values) {
      return std::accumulate(values.begin(), values.end(), 0.0);
    };
    CHECK(sum(by_triangle) == Approx(sum(work)).epsilon(1e-4));
    CHECK(sum(wear) > 0);
    CHECK(9 * file.dataset(liner + "/triangles/work").columns() == file.dataset(liner + "/corners").rows());
  }
  CHECK(file.dataset("/series/wall_force_concave").columns() == 3);
  const Outcome exported = place.gyrosim("export csv maps --table liners/mantle");
  CHECK(exported.code == 2);
  CHECK(exported.err.starts_with("maps has no table liners/mantle; it has breakage, fragments, "));
}

TEST_CASE("A run during start-up is reported as one, and the motor's figures are those of its rows") {
  const Workplace place;
  const Outcome outcome = place.gyrosim("run " + crush + " --until '6 ms' --out r --set output.snapshots=0");
  REQUIRE(outcome.code == 0);
  const nlohmann::json summary = summary_of(place.path() / "r");
  CHECK(summary["steady"].is_null());
  CHECK(summary["not_steady"] == "the run is too short: 0 gyrations, at least 10 are needed");
  CHECK(outcome.out.find("the figures below are of the start-up") != std::string::npos);
  std::vector<double> power = result_of(place.path() / "r", "series/motor_power");
  std::ranges::sort(power);
  CHECK(summary["motor"]["peak"].get<double>() == Approx(power.back()));
  CHECK(summary["motor"]["p95"].get<double>() == Approx(power[11]));  // 12 rows
  CHECK(summary["motor"]["mean"].get<double>() ==
        Approx(std::accumulate(power.begin(), power.end(), 0.0) / 12).epsilon(1e-9));
  CHECK(summary["motor"]["rated_power"].is_null());  // droop has no name plate
}

TEST_CASE("A machine without rock is steady once it has run up, with or without interruption") {
  const Workplace place;
  const std::string run =
      "run '" GYRO_CASES
      "/mkii-62-75/no-load.yaml' --set 'drivetrain.motor={model: induction, "
      "rated_power: 600 kW, synchronous_speed: 600 rpm, rated_slip: 0.0167, breakdown_ratio: 2.5}' ";
  const Outcome outcome = place.gyrosim(run + "--out whole");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  REQUIRE(place.gyrosim(run + "--until '5 s' --out parts").code == 0);
  REQUIRE(place.gyrosim(run + "--resume --out parts").code == 0);
  const nlohmann::json summary = summary_of(place.path() / "whole"), again = summary_of(place.path() / "parts");
  INFO(summary.dump(1));
  const nlohmann::json steady = summary["steady"];
  REQUIRE(steady.is_object());
  CHECK(steady == again["steady"]);
  CHECK(summary["motor"] == again["motor"]);
  CHECK(steady["from"] > 0.5);
  CHECK(steady["throughput_tph"] == 0);
  CHECK(steady["p80_error"].is_null());
  CHECK(steady["motor_power_error"].is_number());
  CHECK(summary["motor"]["from"] == steady["from"]);
  CHECK(summary["motor"]["rated_power"].get<double>() == Approx(600e3));
  CHECK(summary["motor"]["mean_fraction"].get<double>() == Approx(summary["motor"]["mean"].get<double>() / 600e3));
}

TEST_CASE("report prints the summary again, and the log keeps it") {
  const Workplace place;
  const Outcome run = place.gyrosim("run " + crush + " --until '2 ms' --out run --set output.snapshots=0");
  REQUIRE(run.code == 0);
  REQUIRE(run.out.find("discharged") != std::string::npos);
  const Outcome report = place.gyrosim("report run");
  CHECK(report.code == 0);
  CHECK(report.out == run.out);
  const std::string log = read_text(place.path() / "run/log.txt");
  std::istringstream lines(run.out);
  for (std::string line; std::getline(lines, line);) CHECK(log.find(line) != std::string::npos);

  for (const char* nothing : {"nowhere", "."}) {
    const Outcome refused = place.gyrosim(std::string("report ") + nothing);
    CHECK(refused.code == 2);
    CHECK(refused.out.empty());
    CHECK(refused.err.find("summary.json: does not exist; give the directory of a run") != std::string::npos);
  }
  CHECK(place.gyrosim("report").code == 2);
}

TEST_CASE("export csv writes the series with units in the names") {
  const Workplace place;
  REQUIRE(place.gyrosim("run " + crush + " --until '2 ms' --out run --set output.snapshots=0").code == 0);
  CHECK_FALSE(hdf5::File::open(place.path() / "run/results.h5").contains("/liners"));  // the case does not ask for maps
  const Outcome outcome = place.gyrosim("export csv run");
  REQUIRE(outcome.code == 0);
  std::istringstream text(outcome.out);
  std::string header, line;
  std::getline(text, header);
  CHECK(header.starts_with("time_s,"));
  CHECK(header.find(",eccentric_speed_rad/s,") != std::string::npos);
  CHECK(header.find(",mantle_force_x_N,mantle_force_y_N,mantle_force_z_N,") != std::string::npos);
  int rows = 0;
  while (std::getline(text, line)) {
    CHECK(std::count(line.begin(), line.end(), ',') == std::count(header.begin(), header.end(), ','));
    ++rows;
  }
  CHECK(rows == 4);
  CHECK(place.gyrosim("export csv run --out run.csv").code == 0);
  std::ifstream file(place.path() / "run.csv");
  std::string first;
  std::getline(file, first);
  CHECK(first == header);
  CHECK(place.gyrosim("export csv nothing").code == 2);
}

TEST_CASE("Sieves of the case are those of product and hold-up, and stay when a run goes on") {
  const Workplace place;
  const std::string run =
      "run " + crush + " --out run --set output.snapshots=0 --set 'output.sieves=[5 mm, 10 mm, 40 mm]'";
  REQUIRE(place.gyrosim(run + " --until '2 ms'").code == 0);
  REQUIRE(place.gyrosim(run + " --until '3 ms' --resume").code == 0);
  CHECK(result_of(place.path() / "run", "holdup/sizes") == std::vector{0.005, 0.01, 0.04});
  CHECK(place.gyrosim("export csv run --table holdup").out.find(",passing_5mm,passing_10mm,passing_40mm,") !=
        std::string::npos);
  CHECK(place.gyrosim("run " + crush + " --out run --resume --until '4 ms'").code == 2);
}

TEST_CASE("A directory that the file system refuses is bad input, and no abort") {
  const Workplace place;
  const std::string name(300, 'x');
  for (const std::string command : {"report ", "export csv "}) CHECK(place.gyrosim(command + name).code == 2);
}

TEST_CASE("The share below a side setting that lies outside the sieves is missing") {
  const Workplace place;  // settings of 15 mm and 20.4 mm
  const std::string run = "run " + crush + " --until '1 ms' --set output.snapshots=0 --out ";
  REQUIRE(place.gyrosim(run + "upper --set 'output.sieves=[20 mm, 1 m]'").code == 0);
  REQUIRE(place.gyrosim(run + "lower --set 'output.sieves=[1 mm, 20 mm]'").code == 0);
  CHECK(std::isnan(result_of(place.path() / "upper", "holdup/below_css").back()));
  CHECK(result_of(place.path() / "upper", "holdup/below_oss").back() <= 1);
  CHECK(result_of(place.path() / "lower", "holdup/below_css").back() <= 1);
  CHECK(std::isnan(result_of(place.path() / "lower", "holdup/below_oss").back()));
}

TEST_CASE("export csv writes every table, curves with the size of each sieve in its name") {
  const Workplace place;
  REQUIRE(place.gyrosim("run " + crush + " --until '2 ms' --out run --set output.snapshots=0").code == 0);
  const auto first_line = [&](const std::string& table) {
    const Outcome outcome = place.gyrosim("export csv run --table " + table);
    CHECK(outcome.code == 0);
    return outcome.out.substr(0, outcome.out.find('\n'));
  };
  CHECK(first_line("holdup").find(",passing_0.9766mm,passing_1.381mm,") != std::string::npos);
  CHECK(first_line("product").find(",passing_1000mm,") != std::string::npos);
  CHECK(first_line("breakage").starts_with("time_s,energy_J,"));
  CHECK(first_line("ledger").starts_with("time_s,"));
  CHECK(first_line("fragments") ==
        "time_s,fed_s,id,mass_kg,particles,place,position_x_m,position_y_m,position_z_m,rock,size_m,velocity_x_m/s,"
        "velocity_y_m/s,velocity_z_m/s");
  const Outcome wrong = place.gyrosim("export csv run --table pieces");
  CHECK(wrong.code == 2);
  CHECK(wrong.err ==
        "run has no table pieces; it has breakage, fragments, holdup, ledger, performance, product, series\n");
  for (const std::string inner : {"/", "", "series/", "/series", "liners/mantle", "../run"})
    CHECK(place.gyrosim("export csv run --table '" + inner + "'").code == 2);
}
