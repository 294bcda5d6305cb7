// SPDX-License-Identifier: GPL-3.0-or-later
// What a crusher's run leaves about its drive and its liners.
#include "io/hdf5/hdf5.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <fstream>
#include <numeric>
#include <sstream>

using namespace gyro;

namespace {

const std::string crush = "'" GYRO_APP_CASES "/crush.yaml'";

}  // namespace

TEST_CASE("Maps of the liners: asked for, they lie in results.h5, and add up") {
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
}

TEST_CASE("export csv writes the series with units in the names") {
  const Workplace place;
  REQUIRE(place.gyrosim("run " + crush + " --until '2 ms' --out run --set output.snapshots=0").code == 0);
  CHECK_FALSE(hdf5::File::open(place.path() / "run/results.h5").contains("/liners"));  // nobody asked
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
  const Outcome wrong = place.gyrosim("export csv run --table fragments");
  CHECK(wrong.code == 2);
  CHECK(wrong.err == "run has no table fragments; it has breakage, holdup, ledger, performance, product, series\n");
}
