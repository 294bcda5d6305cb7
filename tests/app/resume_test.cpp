// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that continue after any kind of interruption have the same numbers as without it.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"
#include "tests/io/fields/read_fields.hpp"

#include <algorithm>
#include <chrono>
#include <fstream>

namespace {

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

/// Rocks break, are fed, fall through and are removed; rows are longer than windows.
const std::string crush =
    "run '" GYRO_APP_CASES
    "/crush.yaml' --set feed.rate=20 --set 'crusher.removal_depth=1 mm' "
    "--set 'output.series=2 ms' --set 'output.snapshots=5 ms' --set 'output.formats=[vtp, hdf5]' ";
const std::string box = "run '" GYRO_CASES "/box.yaml' ";

void require_same_fields(const fs::path& a, const fs::path& b) {
  const hdf5::File one = hdf5::File::open_closed(a), other = hdf5::File::open_closed(b);
  for (const char* group : {"/VTKHDF", "/bonds", "/liners", "/fragments"}) {
    INFO(group);
    REQUIRE(frame_count(one, group) > 10);
    REQUIRE(frame_count(one, group) == frame_count(other, group));
    for (std::int64_t frame = 0; frame < frame_count(one, group); ++frame)
      CHECK(numbers_of(one, group, frame) == numbers_of(other, group, frame));
  }
}

void require_same_results(const fs::path& a, const fs::path& b) {
  const auto one = all_results(a), other = all_results(b);
  REQUIRE(one.size() == other.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    INFO(one[k].first);
    CHECK(one[k].first == other[k].first);
    CHECK(one[k].second == other[k].second);
  }
  for (const char* name : {"particles.pvd", "bonds.pvd", "walls.pvd", "fragments.pvd"})
    CHECK(read_text(a / name) == read_text(b / name));
  for (const auto& frame : fs::directory_iterator(a / "snapshots")) {
    INFO(frame.path());
    CHECK(read_text(frame.path()) == read_text(b / "snapshots" / frame.path().filename()));
  }
  if (fs::exists(a / "fields.h5")) require_same_fields(a / "fields.h5", b / "fields.h5");
  const nlohmann::json first = summary_of(a), second = summary_of(b);
  for (const auto& [key, value] : first.items()) {
    INFO(key);
    if (key != "wall_seconds" && key != "threads") CHECK(second[key] == value);
  }
}

/// A small run of 1600 windows with a bouncing sphere, for tests that do not depend on the case.
const std::string bounce = box +
                           "--set 'output.snapshots=50 ms' --set 'output.series=3 ms' --set 'time.duration=0.8 s' "
                           "--set 'output.probes=[1, 17]' ";

}  // namespace

TEST_CASE(
    "A run in parts has the numbers of an uninterrupted one: breaking, feeding, removal, either precision, any "
    "threads") {
  const std::string precision = GENERATE(as<std::string>{}, "mixed", "double");
  const Workplace place;
  const std::string run =
      crush + "--set 'output.liners={interval: 7 ms, rows: 40, sectors: 60}' --set numerics.precision=" + precision;
  REQUIRE(place.gyrosim(run + " --until '130 ms' --out whole").code == 0);
  const nlohmann::json whole = summary_of(place.path() / "whole");
  REQUIRE(whole["bonds_broken"] > 50);
  REQUIRE(result_of(place.path() / "whole", "series/feed_mass").back() >
          result_of(place.path() / "whole", "series/feed_mass").front());
  const std::vector<double> particles = result_of(place.path() / "whole", "series/particles");
  REQUIRE(std::adjacent_find(particles.begin(), particles.end(), std::greater<>()) != particles.end());  // removal

  REQUIRE(place.gyrosim(run + " --until '17 ms' --out parts").code == 0);  // in the middle of a row
  REQUIRE(place.gyrosim(run + " --until '119 ms' --out parts --resume --threads 2").code == 0);
  const Outcome last = place.gyrosim(run + " --until '130 ms' --out parts --resume");
  REQUIRE(last.code == 0);
  require_same_results(place.path() / "whole", place.path() / "parts");
  CHECK(read_text(place.path() / "parts/log.txt").find("resumed at t = 0.119") != std::string::npos);
}

TEST_CASE("A run stopped by --max-walltime or a signal continues to its end with the same numbers") {
  const bool by_signal = GENERATE(false, true);
  const Workplace place;
  REQUIRE(place.gyrosim(bounce + "--out whole").code == 0);
  int parts = 1, code = 0;
  for (; parts < 100; ++parts) {
    const std::string run = bounce + "--out parts --resume";
    code = by_signal ? place.gyrosim_with_signal(run, "TERM", 0.1 + 0.05 * parts).code
                     : place.gyrosim(run + " --max-walltime " + std::to_string(0.05 * parts)).code;
    if (by_signal && code == 143) continue;  // the signal came before the program could catch it
    if (code != 75) break;
    if (!fs::exists(place.path() / "parts/summary.json")) continue;  // it came while the case was loaded
    CHECK(summary_of(place.path() / "parts")["status"] == "interrupted");
    CHECK(fs::exists(place.path() / "parts/checkpoint.h5"));
  }
  CHECK(code == 0);
  CHECK(parts > 1);
  require_same_results(place.path() / "whole", place.path() / "parts");
}

TEST_CASE("A run that is killed repeatedly continues from its last checkpoint with the same numbers") {
  const Workplace place;
  REQUIRE(place.gyrosim(bounce + "--out whole").code == 0);
  const std::string run = bounce + "--set 'output.checkpoints=20 ms' --out parts --resume";
  int kills = 0;
  Outcome last{-1, "", ""};
  for (; kills < 100; ++kills) {
    last = place.gyrosim_with_signal(run, "KILL", 0.15 + 0.05 * kills);
    if (last.code == 0) break;
    INFO(last.err);
    REQUIRE(last.code == 137);
  }
  INFO(last.err);
  CHECK(last.code == 0);
  CHECK(kills > 1);
  require_same_results(place.path() / "whole", place.path() / "parts");
}

TEST_CASE("A finished run continues if its end is later, and is not changed otherwise") {
  const Workplace place;
  const fs::path run = place.path() / "r";
  const std::string box = ::box + "--set 'output.series=1 ms' ";
  REQUIRE(place.gyrosim(box + "--out r --until '5 ms'").code == 0);
  const std::string summary = read_text(run / "summary.json");
  for (const std::string until : {"'5 ms'", "'3 ms'"}) {
    CHECK(place.gyrosim(box + "--out r --resume --until " + until).code == 0);
    CHECK(read_text(run / "summary.json") == summary);
  }
  CHECK(place.gyrosim(box + "--out r --until '8 ms'").code == 0);
  CHECK(read_text(run / "summary.json") == summary);
  const Outcome other = place.gyrosim(box + "--out r --until '5 ms' --set case.seed=77");
  CHECK(other.code == 2);
  CHECK(other.err.find("case.seed is 77") != std::string::npos);
  CHECK(read_text(run / "summary.json") == summary);
  CHECK(place.gyrosim(box + "--out r --resume --until '8 ms'").code == 0);
  CHECK(summary_of(run)["simulated_seconds"].get<double>() == Approx(0.008));
  CHECK(place.gyrosim(box + "--out r --resume --set 'time.duration=9 ms'").code == 0);
  CHECK(summary_of(run)["simulated_seconds"].get<double>() == Approx(0.009));
  CHECK(result_of(run, "series/time").size() == 9);
}

TEST_CASE("Outputs that determine columns may not change when a run continues, and the message names the key") {
  const Workplace place;
  const std::string cut = box + "--out r --until '5 ms' --set 'output.series=1 ms' --set 'output.probes=[1, 17]'";
  REQUIRE(place.gyrosim(cut).code == 0);
  for (const std::string probes : {"null", "[1]", "[1, 17, 18]"}) {
    const Outcome outcome = place.gyrosim(box + "--out r --resume --until '8 ms' --set 'output.probes=" + probes + "'");
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Contains("--set:1:1: output.probes is ") && Contains("in r/checkpoint.h5 [1, 17]") &&
                                Contains("only time.duration, output.series"));
  }
  const Outcome maps = place.gyrosim(
      box + "--out r --resume --until '8 ms' --set 'output.probes=[1, 17]' --set output.liners.interval=1ms");
  CHECK(maps.code == 2);
  CHECK_THAT(maps.err, Contains("output.liners"));
}

TEST_CASE("The intervals of the output may change when a run continues") {
  const Workplace place;
  REQUIRE(place.gyrosim(box + "--out r --until '10 ms' --set 'output.series=4 ms'").code == 0);
  REQUIRE(place
              .gyrosim(box + "--out r --resume --until '12 ms' --set 'output.series=1 ms' "
                             "--set 'output.snapshots=1 ms'")
              .code == 0);
  const std::vector<double> time = result_of(place.path() / "r", "series/time");
  REQUIRE(time.size() == 4);  // 4 and 8 ms, then each millisecond from 10 ms on
  CHECK(time[1] == Approx(0.008));
  CHECK(time[2] == Approx(0.011));
  CHECK(fs::exists(place.path() / "r/snapshots/particles_000002.vtp"));
  CHECK_FALSE(fs::exists(place.path() / "r/snapshots/particles_000003.vtp"));
}

TEST_CASE("Only the same case continues, a difference is reported with its place, and no file changes") {
  const Workplace place;
  place.write("start.csv", "id,x,y,z,r\n1,0,0,0.05,0.01\n2,0,0,0.08,0.01\n");
  const std::string run = box + "--out r --set particles.file=" + (place.path() / "start.csv").string();
  REQUIRE(place.gyrosim(run + " --until '5 ms'").code == 0);
  const std::string checkpoint = read_text(place.path() / "r/checkpoint.h5"),
                    results = read_text(place.path() / "r/results.h5");
  const auto refused = [&](const std::string& change, const std::string& message) {
    const Outcome outcome = place.gyrosim(run + " --resume --until '9 ms' " + change);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Contains(message) && Contains("checkpoint.h5"));
    CHECK(read_text(place.path() / "r/results.h5") == results);
  };
  refused("--set numerics.precision=double", "numerics.precision is double");
  refused("--set numerics.precision=double", "--set:2:1: ");
  refused("--set case.seed=77", "case.seed is 77");
  refused("--set 'gravity=[0, 0, -5]'", "gravity is [0, 0, -5]");
  place.write("start.csv", "id,x,y,z,r\n1,0,0,0.05,0.01\n2,0,0,0.09,0.01\n");
  refused("", "start.csv: has changed");
  place.write("start.csv", "id,x,y,z,r\n1,0,0,0.05,0.01\n2,0,0,0.08,0.01\n");
  std::ofstream(place.path() / "r/checkpoint.h5") << checkpoint.substr(0, checkpoint.size() / 2);
  refused("", "r/checkpoint.h5: is damaged");
  std::ofstream(place.path() / "r/checkpoint.h5") << checkpoint;
  fs::rename(place.path() / "r/checkpoint.h5", place.path() / "r/away");
  refused("", "r/checkpoint.h5: there is no such checkpoint");
  fs::rename(place.path() / "r/away", place.path() / "r/checkpoint.h5");
  CHECK(place.gyrosim(run + " --resume --until '9 ms'").code == 0);
}

TEST_CASE("A run that a guard stops keeps its last good state, and stops there again") {
  const Workplace place;
  // A sphere falls faster and faster, until it would pass another within a step.
  place.write("two.csv", "id,x,y,z,r,vx,vy,vz\n1,0,0,0.05,0.01,0,0,0\n2,0.05,0,0.15,0.01,0,0,0\n");
  const std::string run = box +
                          "--out r --set 'time.duration=1 s' --set 'gravity=[0, 0, -20000]' --set particles.file=" +
                          (place.path() / "two.csv").string();
  const Outcome first = place.gyrosim(run);
  INFO(first.err);
  REQUIRE(first.code == 4);
  REQUIRE(fs::exists(place.path() / "r/checkpoint.h5"));
  const nlohmann::json summary = summary_of(place.path() / "r");
  const auto results = all_results(place.path() / "r");
  const Outcome again = place.gyrosim(run + " --resume");
  CHECK(again.code == 4);
  CHECK(summary_of(place.path() / "r")["reason"] == summary["reason"]);
  CHECK(all_results(place.path() / "r") == results);
}

TEST_CASE("A run that was killed before its first checkpoint starts from the beginning when resumed") {
  const Workplace place;
  const std::string run = bounce + "--set 'output.checkpoints=1 h' --out r --resume";
  for (double seconds = 0.2; !fs::exists(place.path() / "r/results.h5") && seconds < 60; seconds *= 2)
    REQUIRE(place.gyrosim_with_signal(run + " --until '10 h'", "KILL", seconds).code == 137);
  REQUIRE_FALSE(fs::exists(place.path() / "r/checkpoint.h5"));
  const Outcome other = place.gyrosim(run + " --set case.seed=5");
  CHECK(other.code == 2);
  CHECK_THAT(other.err, Contains("case.seed is 5"));
  const Outcome again = place.gyrosim(run);
  CHECK(again.code == 0);
  CHECK_THAT(again.err, Contains("holds no checkpoint yet"));
  REQUIRE(place.gyrosim(bounce + "--out whole").code == 0);
  require_same_results(place.path() / "whole", place.path() / "r");
}

namespace {

/// Flips a bit of the number in a file that these bytes are.
void damage(const fs::path& file, const void* number, std::size_t size) {
  std::string bytes = read_text(file);
  const std::size_t at = bytes.rfind(std::string(static_cast<const char*>(number), size));
  REQUIRE(at != std::string::npos);
  bytes[at] = static_cast<char>(bytes[at] ^ 4);
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace

TEST_CASE("A damaged block of a table or of a liner map is not resumed, and is named") {
  const Workplace place;
  const std::string run = crush + "--set 'output.liners={interval: 7 ms, rows: 40, sectors: 60}' --out r ";
  REQUIRE(place.gyrosim(run + "--until '40 ms'").code == 0);
  const fs::path results = place.path() / "r/results.h5";
  const std::string whole = read_text(results);
  const auto refused = [&](const std::string& dataset) {
    const std::string damaged = read_text(results);
    const Outcome outcome = place.gyrosim(run + "--resume --until '50 ms'");
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Contains("results.h5: is damaged: the numbers of " + dataset + " are not those"));
    CHECK(read_text(results) == damaged);
    std::ofstream(results, std::ios::binary) << whole;
  };
  const double power = result_of(place.path() / "r", "series/crushing_power").at(5);
  damage(results, &power, sizeof power);
  refused("/series/crushing_power");
  const std::vector<double> map = result_of(place.path() / "r", "liners/mantle/pressure");
  const auto largest = static_cast<float>(*std::max_element(map.begin(), map.end()));
  damage(results, &largest, sizeof largest);
  refused("/liners/mantle/pressure");
  CHECK(place.gyrosim(run + "--resume --until '50 ms'").code == 0);
}

TEST_CASE("A resumed run that is killed or fails reports its figures, not zeros") {
  const Workplace place;
  const std::string run = crush + "--set 'output.liners={interval: 1 ms, rows: 40, sectors: 60}' --out r ";
  REQUIRE(place.gyrosim(run + "--until '40 ms'").code == 0);
  const nlohmann::json before = summary_of(place.path() / "r");
  REQUIRE(before["bonds_broken"] > 0);
  const bool by_kill = GENERATE(true, false);
  if (by_kill) {
    for (double seconds = 0.2; summary_of(place.path() / "r")["status"] == "done" && seconds < 60; seconds *= 2) {
      const Outcome killed = place.gyrosim_with_signal(run + "--resume --until '1 h'", "KILL", seconds);
      INFO(killed.err);
      REQUIRE(killed.code == 137);
    }
  } else {
    const auto size = fs::file_size(place.path() / "r/results.h5");
    const std::string flushed = run + "--set 'output.checkpoints=0.5 s' --resume --until '10 s'";
    REQUIRE(place.gyrosim_with_file_limit(flushed, size + 100000).code == 5);
  }
  const nlohmann::json after = summary_of(place.path() / "r");
  CHECK(after["status"] == (by_kill ? "interrupted" : "failed"));
  for (const char* figure : {"particles", "particle_steps", "bonds_initial", "bonds_broken", "bond_steps", "feed_mass",
                             "discharged_mass", "simulated_seconds"}) {
    INFO(figure);
    if (by_kill)
      CHECK(after[figure] == before[figure]);  // of the checkpoint
    else
      CHECK(after[figure] >= before[figure]);
  }
  const Outcome report = place.gyrosim("report r");
  CHECK(report.code == 0);
  CHECK_THAT(report.out,
             Contains("particles         " + std::to_string(after["particles"].get<int>()) + " at the end"));
}

TEST_CASE("A signal or --max-walltime ends a run inside a window that takes long, and it goes on from its begin") {
  const bool by_signal = GENERATE(true, false);
  const Workplace place;
  const std::string run = box +
                          "--set 'time.duration=80 s' --set 'coupling.interval=40 s' --set 'output.series=40 s' " +
                          "--set 'output.snapshots=0 s' --out r ";
  const auto begin = std::chrono::steady_clock::now();
  // A second and a half after the run has its results file, however slow the machine is.
  const Outcome stopped =
      by_signal ? place.shell(
                      "sh -c '(until ls r/results.h5 > /dev/null 2>&1; do sleep 0.1; done; sleep 1.5; kill -TERM "
                      "$$) & exec \"$GYROSIM\" \"$@\"' sh " +
                      run)
                : place.gyrosim(run + "--max-walltime '1 s'");
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  INFO(stopped.err);
  CHECK(stopped.code == 75);
  CHECK(passed.count() < 60);  // 2 s on a quiet machine
  const nlohmann::json summary = summary_of(place.path() / "r");
  CHECK(summary["status"] == "interrupted");
  CHECK(summary["simulated_seconds"] == 0);
  CHECK(summary["particles"] > 0);
  CHECK_THAT(summary["reason"].get<std::string>(),
             Contains(by_signal ? "a signal asked to stop" : "--max-walltime is over") &&
                 Contains("; the coupling window from t = 0 s on was given up after ") &&
                 Contains("coupling.interval"));
  CHECK(result_of(place.path() / "r", "series/time").empty());
  CHECK(place.gyrosim(run + "--resume --max-walltime '0.5 s'").code == 75);
  CHECK_THAT(read_text(place.path() / "r/log.txt"), Contains("resumed at t = 0.000000 s"));
}

TEST_CASE("An interrupted run prints the command that continues it, with its options, for a shell") {
  const Workplace place;
  const Outcome first =
      place.gyrosim(bounce + "--until '0.123456789 s' --threads 1 --max-walltime '20 ms' --out 'a run'");
  REQUIRE(first.code == 75);
  const std::string mark = "to continue: gyrosim ";
  const std::size_t at = first.err.find(mark);
  REQUIRE(at != std::string::npos);
  const std::string command = first.err.substr(at + mark.size(), first.err.find('\n', at) - at - mark.size());
  CHECK_THAT(command, Contains("--until 0.123456789 --max-walltime 0.02 --threads 1 --out 'a run' --resume"));
  const double before = summary_of(place.path() / "a run")["simulated_seconds"];
  const Outcome second = place.gyrosim(command);
  CHECK((second.code == 75 || second.code == 0));
  CHECK(summary_of(place.path() / "a run")["simulated_seconds"] > before);
}
