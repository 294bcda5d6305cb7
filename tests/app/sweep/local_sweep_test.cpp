// SPDX-License-Identifier: GPL-3.0-or-later
// Sweeps as a user runs them on one machine.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace {

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

/// Four points of a bouncing sphere in a box, which take about a second each.
const std::string box_sweep = "case: '" GYRO_CASES
                              "/box.yaml'\n"
                              "set: {time.duration: 0.4 s, output.snapshots: 0 s, output.series: 3 ms}\n"
                              "seeds: [1, 2]\n"
                              "vary: {contacts.rock/rock.friction: [0.4, 0.5]}\n"
                              "names: {contacts.rock/rock.friction: f}\n";

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++count;
  return count;
}

std::vector<fs::path> points_in(const fs::path& sweep) {
  std::vector<fs::path> points;
  for (const auto& entry : fs::directory_iterator(sweep))
    if (entry.is_directory() && entry.path().filename() != "logs") points.push_back(entry.path());
  std::sort(points.begin(), points.end());
  return points;
}

/// The rows of results.csv without the column `wall_seconds`.
std::string without_cost(const std::string& csv) {
  std::istringstream lines(csv);
  std::string line, result;
  std::size_t column = std::string::npos;
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t k = 0; std::getline(cells, cell, ','); ++k) {
      if (cell == "wall_seconds") column = k;
      if (k != column) result += cell + ",";
    }
    result += "\n";
  }
  return result;
}

}  // namespace

TEST_CASE("A sweep runs its points, and a repeated call runs none of them again") {
  const Workplace place;
  place.write("s.yaml", box_sweep);
  const Outcome first = place.gyrosim("sweep s.yaml --jobs 2");
  INFO(first.err);
  REQUIRE(first.code == 0);
  CHECK(count_of(first.err, "] done ") == 4);
  CHECK_THAT(first.out, Contains("Means and standard errors over the seeds"));
  const fs::path sweep = place.path() / "runs/s";
  REQUIRE(points_in(sweep).size() == 4);
  for (const fs::path& point : points_in(sweep)) CHECK(summary_of(point)["status"] == "done");
  CHECK(count_of(read_text(sweep / "points.csv"), "\n") == 5);
  const std::string csv = read_text(sweep / "results.csv");
  CHECK(count_of(csv, ",done,") == 4);
  CHECK_THAT(csv, Contains("name,contacts.rock/rock.friction,seed,status,simulated_seconds"));

  const Outcome second = place.gyrosim("sweep s.yaml");
  CHECK(second.code == 0);
  CHECK_THAT(second.err, Contains("4 points are done already") && !Contains("start"));
  CHECK(read_text(sweep / "results.csv") == csv);

  place.write("s.yaml", box_sweep + "until: 0.41 s\n");  // a later end continues all
  CHECK(count_of(place.gyrosim("sweep s.yaml").err, "] continue ") == 4);
}

TEST_CASE("A sweep that is stopped by a signal goes on with the same bits, and takes points that were added") {
  const Workplace place;
  place.write("s.yaml", box_sweep);
  REQUIRE(place.gyrosim("sweep s.yaml --out whole --quiet").code == 0);
  int calls = 1;
  Outcome outcome{75, "", ""};
  for (; calls < 50 && outcome.code == 75; ++calls) {
    outcome = place.gyrosim_with_signal("sweep s.yaml --out parts --jobs 2", "TERM", 0.3 + 0.1 * calls);
    if (outcome.code == 143) outcome.code = 75;      // the signal came while the points were checked
    if (outcome.code == 75 && !outcome.err.empty())  // or it came while the cases were loaded
      CHECK_THAT(outcome.err, Contains("continue with: gyrosim sweep") || Contains("while the case was being loaded"));
  }
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(calls > 2);
  for (const fs::path& point : points_in(place.path() / "whole"))
    CHECK(all_results(point) == all_results(place.path() / "parts" / point.filename()));
  CHECK(without_cost(read_text(place.path() / "parts/results.csv")) ==
        without_cost(read_text(place.path() / "whole/results.csv")));

  std::string longer = box_sweep;
  longer.replace(longer.find("[1, 2]"), 6, "[3, 1, 2]");
  place.write("s.yaml", longer);
  const Outcome added = place.gyrosim("sweep s.yaml --out whole --dry-run");
  CHECK_THAT(added.out, Contains("6 points: 4 done 2 waiting"));
}

TEST_CASE("Two calls at the same time run no point twice") {
  const Workplace place;
  place.write("s.yaml", box_sweep);
  const Outcome both = place.shell("$GYROSIM sweep s.yaml --jobs 1 2>one & $GYROSIM sweep s.yaml --jobs 2 2>two; wait");
  INFO(both.err);
  const std::string one = read_text(place.path() / "one"), two = read_text(place.path() / "two");
  INFO(one << two);
  CHECK(count_of(one + two, "FAILED") == 0);
  CHECK(count_of(one, "] done f-") + count_of(two, "] done f-") == 4);
  CHECK(place.gyrosim("sweep s.yaml").code == 0);
}

TEST_CASE("Points whose settings or input files have changed since they were run are named, and nothing is run") {
  const Workplace place;
  place.write("s.yaml", box_sweep);
  fs::copy_file(GYRO_CASES "/box.yaml", place.path() / "box.yaml");
  fs::copy_file(GYRO_CASES "/box-particles.csv", place.path() / "box-particles.csv");
  std::string own = "case: box.yaml\n" + box_sweep.substr(box_sweep.find('\n') + 1) + "until: 5 ms\n";
  place.write("s.yaml", own);
  REQUIRE(place.gyrosim("sweep s.yaml").code == 0);

  place.write("s.yaml", own + "threads: 2\n");  // changes no result
  CHECK(place.gyrosim("sweep s.yaml").code == 0);
  std::string other = own;
  other.replace(other.find("output.series"), 0, "time.safety: 0.5, ");
  place.write("s.yaml", other);
  const Outcome changed = place.gyrosim("sweep s.yaml");
  CHECK(changed.code == 2);
  CHECK_THAT(changed.err, Contains("s.yaml:2:") && Contains("now has time.safety = 0.5") && Contains("seed-2"));

  place.write("s.yaml", own);
  REQUIRE(place.shell("echo >>box-particles.csv").code == 0);
  const Outcome input = place.gyrosim("sweep s.yaml");
  CHECK(input.code == 2);
  CHECK_THAT(input.err, Contains("s.yaml:1:7: a file that the case names has changed since the point f-0.4_seed-1"));
}

TEST_CASE("A point that fails or that a guard stops holds up no other, and is run again with --retry only") {
  const Workplace place;
  place.write("s.yaml", "case: '" GYRO_APP_CASES
                        "/platen.yaml'\n"
                        "set: {time.duration: 5 ms}\nvary: {time.safety: [0.5, 0.7]}\nnames: {time.safety: s}\n");
  REQUIRE(place.gyrosim("sweep s.yaml --quiet").code == 0);
  const fs::path run = place.path() / "runs/s/s-0.5_seed-1";
  std::string summary = read_text(run / "summary.json");
  for (const auto& [status, code] : {std::pair{"failed", 1}, std::pair{"stopped", 4}}) {
    std::string changed = summary;
    changed.replace(changed.find("\"done\""), 6, std::string("\"") + status + "\"");
    std::ofstream(run / "summary.json") << changed;
    const Outcome again = place.gyrosim("sweep s.yaml");
    CHECK(again.code == code);
    CHECK_THAT(again.err, Contains(std::string(status) + " before: s-0.5_seed-1; --retry runs it again"));
    CHECK_THAT(read_text(place.path() / "runs/s/results.csv"), Contains(std::string(",") + status + ","));
  }
  CHECK(place.gyrosim("sweep s.yaml --retry").code == 0);
  CHECK(summary_of(run)["status"] == "done");
}

TEST_CASE("A value that shows to be bad only when a run begins fails its point, with the place in the sweep file") {
  const Workplace place;
  place.write("s.yaml", "case: '" GYRO_APP_CASES
                        "/platen.yaml'\nset: {time.duration: 1 ms}\nvary:\n  time.step: [auto, 0.2 ms]\n");
  const Outcome outcome = place.gyrosim("sweep s.yaml");
  CHECK(outcome.code == 1);
  CHECK_THAT(outcome.err, Contains("FAILED step-0.2ms_seed-1: exit code 2; s.yaml:4:21: the time step of 0.0002 s"));
  CHECK_THAT(outcome.err, Contains("1 done, 0 stopped by a guard, 1 failed"));
}

TEST_CASE("A bad sweep, a directory of something else, and results of nothing are refused, and nothing is written") {
  const Workplace place;
  place.write("s.yaml", box_sweep + "seds: 3\n");
  const Outcome bad = place.gyrosim("sweep s.yaml");
  CHECK(bad.code == 2);
  CHECK_THAT(bad.err, Contains("s.yaml:6:1: unknown key \"seds\"; did you mean \"seeds\"?"));
  place.write("s.yaml", box_sweep);
  CHECK(place.gyrosim("sweep s.yaml --collect").code == 2);
  CHECK(place.gyrosim("sweep s.yaml --dry-run").code == 0);
  CHECK(place.gyrosim("sweep s.yaml --dry-run --collect").code == 2);
  CHECK(place.gyrosim("sweep s.yaml --engine pbs").code == 2);
  CHECK_THAT(place.gyrosim("sweep s.yaml --engine slurm --jobs 2").err, Contains("`at_once` below `slurm`"));
  CHECK(place.gyrosim("sweep s.yaml --out s.yaml").code == 2);
  place.write("results.h5", "mine");
  CHECK_THAT(place.gyrosim("sweep s.yaml --out .").err, Contains("which is not of a sweep"));
  CHECK(place.listing() == std::vector<std::string>{"results.h5", "s.yaml"});
}
