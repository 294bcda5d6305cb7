// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/sweep_file.hpp"

#include "app/sweep/checked_points.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

namespace {

using namespace gyro;
using Catch::Matchers::Contains;

const std::string first_line = "case: '" GYRO_APP_CASES "/platen.yaml'\n";

/// The problems of a sweep file and of its points, one a line, without the name of the file.
std::string problems_of(const std::string& text) {
  const Workplace place;
  place.write("s.yaml", text);
  const std::string file = (place.path() / "s.yaml").string();
  const SweepReport report = load_sweep(file);
  std::string lines;
  for (const CaseProblem& problem : report.loaded ? check_points(*report.loaded).problems : report.problems) {
    CHECK(problem.file == file);
    lines += std::to_string(problem.line) + ":" + std::to_string(problem.column) + ": " + problem.message + "\n";
  }
  return lines;
}

CheckedSweep checked(const std::string& text) {
  const Workplace place;
  place.write("s.yaml", text);
  const SweepReport report = load_sweep(place.path() / "s.yaml");
  REQUIRE(report.loaded);
  return check_points(*report.loaded);
}

}  // namespace

TEST_CASE("All mistakes of a sweep file are reported together, each at its place") {
  const std::string problems = problems_of(first_line +
                                           "sets: {time.duration: 20 ms}\n"
                                           "until: 3 mm\n"
                                           "seeds: [1, 1, -2, x]\n"
                                           "time.step: 1 us\n"
                                           "vary:\n"
                                           "  bonds.radius.relative: [0.3, 0.5, 0.3]\n"
                                           "  time.duration: 3\n"
                                           "  case.seed: [1]\n"
                                           "together: {time.safety: [0.5, 0.6], gravity: [1]}\n"
                                           "latin_hypercube: {ranges: {rocks.fill.ratio: [4 m, 3 mm]}}\n"
                                           "threads: 0\n"
                                           "names: {gravity: g h}\n"
                                           "slurm: {tim: 1, options: [x, --array=1]}\n");
  for (const char* expected :
       {"2:1: unknown key \"sets\"; did you mean \"set\"?", "3:8: until: \"3 mm\" is a length",
        "4:12: seeds has 1 twice", "4:15: seeds = -2 is out of range", "4:19: seeds: \"x\" is not a number",
        "5:1: unknown key \"time.step\"; it is a key of the case: put it below `vary`",
        "7:37: bonds.radius.relative has \"0.3\" twice", "8:18: time.duration has the wrong form",
        "9:3: the seed of a point comes from `seeds`", "10:46: gravity has 1 values and time.safety 2",
        "11:1: latin_hypercube has no points", "11:52: rocks.fill.ratio: the two ends have different units",
        "12:10: threads = 0 is out of range", "13:9: names: gravity does not vary", "13:18: names: a short name begins",
        "14:9: unknown key \"tim\" in slurm; did you mean \"time\"?", "14:27: options: this is not an option",
        "14:30: options: the sweep numbers its tasks itself"})
    CHECK_THAT(problems, Contains(expected));
  CHECK(std::count(problems.begin(), problems.end(), '\n') == 18);
}

TEST_CASE("Values that the case does not take are reported at their places, once for all points") {
  const std::string problems = problems_of(first_line +
                                           "set: {time.duration: 20 mm}\n"
                                           "vary:\n"
                                           "  bonds.radius.relative: [0.3, -0.5]\n"
                                           "  bonds.radus.relative: [0.3, 1]\n"
                                           "seeds: 3\n");
  CHECK_THAT(problems, Contains("2:22: time.duration: \"20 mm\" is a length"));
  CHECK_THAT(problems, Contains("4:32: bonds.radius.relative = -0.5 is out of range"));
  CHECK_THAT(problems, Contains("5:3: unknown key \"radus\" in bonds; did you mean \"radius\"?"));
  CHECK(std::count(problems.begin(), problems.end(), '\n') == 3);
}

TEST_CASE("A sweep file without a case, with a case that is missing, or that is no map is refused") {
  CHECK_THAT(problems_of("seeds: 2\n"), Contains("1:1: required key \"case\" is missing"));
  CHECK_THAT(problems_of("seeds: 2\ncase: nowhere.yaml\n"), Contains("2:7: case: there is no file "));
  CHECK_THAT(problems_of("[1, 2]\n"), Contains("1:1: is not a sweep file"));
  CHECK_THAT(problems_of(first_line + "seeds: 2\nseeds: 3\n"), Contains("3:1: "));
  CHECK_THAT(problems_of(first_line + "vary:\n"), Contains("2:1: vary is empty"));
}

TEST_CASE("Keys that vary twice, too many points, and points with the same case are refused") {
  CHECK_THAT(problems_of(first_line + "set: {time.safety: 0.5}\nvary: {time.safety: [0.5, 0.6]}\n"),
             Contains("3:8: time.safety is given in line 2 already"));
  CHECK_THAT(
      problems_of(first_line + "seeds: 1000\nlatin_hypercube: {points: 1000, ranges: {time.safety: [0.1, 0.5]}}\n"),
      Contains("the sweep has more than 100,000 points"));
  CHECK_THAT(problems_of(first_line + "vary: {time.safety: [0.5, 0.50]}\n"),
             Contains("2:27: the points safety-0.5_seed-1 and safety-0.50_seed-1 have the same case"));
}

TEST_CASE("A sweep without seeds takes that of the case, and a sample keeps its unit") {
  const CheckedSweep sweep = checked(first_line +
                                     "latin_hypercube: {points: 3, ranges: {time.duration: [10 ms, 20 ms, log]}}\n"
                                     "names: {time.duration: t}\n");
  CHECK(sweep.problems.empty());
  REQUIRE(sweep.points.size() == 3);
  for (const CheckedPoint& point : sweep.points) {
    CHECK(point.name == point.setting + "_seed-1");
    CHECK_THAT(point.name, Catch::Matchers::Matches("t-1[0-9.]+ms_seed-1"));
    CHECK(point.end >= 0.01);
    CHECK(point.end <= 0.02);
    CHECK(resolved_value(point.resolved, "time.duration") != "");
  }
}
