// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"
#include "app/report/case_facts.hpp"
#include "tests/catch.hpp"

#include <cmath>

using namespace gyro;
using namespace gyro::report;

TEST_CASE("A running mean stands at the middle of its rows and starts where they reach back far enough") {
  std::vector<double> time, values;
  for (int k = 1; k <= 100; ++k) time.push_back(0.1 * k), values.push_back(k % 2 ? 3 : 1);
  const Points means = running_mean(time, values, 1);
  REQUIRE(means.x.size() == 91);  // the rows of the first second together, and each later one
  CHECK(means.x.front() == Approx(0.5));
  CHECK(means.x.back() == Approx(9.5));
  for (const double mean : means.y) CHECK(mean == Approx(2));
  values[50] = std::nan("");
  for (const double mean : running_mean(time, values, 1).y) CHECK(std::isfinite(mean));
  CHECK(running_mean({}, {}, 1).x.empty());
}

TEST_CASE("A size is interpolated on the logarithm between two sieves") {
  const SizeCurve curve{{0.01, 0.04, 0.1}, {0.2, 0.6, 1}};
  CHECK(passing_size(curve, 0.4).value() == Approx(0.02));
  CHECK(passing_size(curve, 1).value() == Approx(0.1));
  CHECK_FALSE(passing_size(curve, 0.1));
  CHECK_FALSE(passing_size({}, 0.5));
}

TEST_CASE("The facts of a case are read from its resolved text") {
  const std::string yaml =
      "contacts:\n  rock/steel: {friction: 0.7}\nwalls:\n  mantle: {material: steel}\n"
      "crusher: {closed_side_setting: 0.12, eccentricity: 0.02}\n"
      "rocks:\n  sizes:\n    passing: [[0.1, 0], [0.3, 1]]\n"
      "output:\n  liners: {wear_coefficient: 1e-12}\n  fines: {breakage: {A: 0.6}}\n";
  const CaseFacts facts = case_facts(yaml, "nowhere.yaml");
  CHECK(facts.closed_setting.value() == 0.12);
  CHECK(facts.open_setting.value() == Approx(0.16));
  CHECK(facts.wear_coefficient.value() == 1e-12);
  CHECK(facts.wall_friction.at("mantle") == 0.7);
  const auto feed = feed_curve(facts);
  REQUIRE(feed);
  CHECK(passing_size(*feed, 0.8).value() == Approx(0.26).epsilon(1e-3));
  CHECK(feed->passing.back() == 1);
}

TEST_CASE("A case without these parts, or a damaged one, has no facts and is no error") {
  for (const char* yaml : {"", "case: {title: a}", "crusher: 5", "rocks: {sizes: {passing: [[1, 0]]}}", "{[",
                           "rocks: {sizes: {rosin_rammler: {x63: 0}}}", "rocks: {sizes: {sieves: gone.csv}}"}) {
    const CaseFacts facts = case_facts(yaml, "nowhere.yaml");
    CHECK_FALSE(facts.closed_setting);
    CHECK_FALSE(facts.feed);
  }
}

TEST_CASE("Time by phase is summed over the parts of a run") {
  const auto phases = phases_of(
      "2026-01-01 00:00:00.0 info: phase pair forces: 1.5 s\n2026-01-01 00:00:00.0 info: phase a: b: 2 s\n"
      "x info: phase pair forces: 1.0 s\ninfo: status done\n info: phase broken\n");
  REQUIRE(phases.size() == 2);
  CHECK(phases[0] == std::pair<std::string, double>("pair forces", 2.5));
  CHECK(phases[1] == std::pair<std::string, double>("a: b", 2));
}

TEST_CASE("Runs with the same name on one page get their paths as names") {
  std::vector<RunData> runs(3);
  runs[0].directory = "/a/r", runs[1].directory = "/b/r", runs[2].directory = "/b/other/";
  name_runs(runs);
  CHECK(runs[0].name == "/a/r");
  CHECK(runs[1].name == "/b/r");
  CHECK(runs[2].name == "other");
  runs[0].directory = runs[1].directory = "/b/r/";
  name_runs(runs);
  CHECK(runs[0].name != runs[1].name);
}
