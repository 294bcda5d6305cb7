// SPDX-License-Identifier: GPL-3.0-or-later
// The directory of a run, and the ways in which a run ends.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <map>

namespace {

using namespace gyro;
namespace fs = std::filesystem;

const std::string box = "'" GYRO_CASES "/box.yaml'";
const std::string endless = box + " --set 'time.duration=10 h' --set output.snapshots=0";

/// Takes a run's snapshots from it after the third frame, and waits for its end.
const std::string moved_away =
    "until test -e r/snapshots/particles_000002.vtp || ! kill -0 $run 2>/dev/null; do sleep 0.02; done; "
    "mv r/snapshots away; wait $run";

/// Number of frames that an index names.
std::size_t frames_in(const fs::path& index) {
  const std::string text = read_text(index);
  std::size_t frames = 0;
  for (std::size_t at = text.find("file="); at != std::string::npos; at = text.find("file=", at + 1)) ++frames;
  return frames;
}

/// Number of files particles_NNNNNN.vtp in a directory.
std::size_t particle_files(const fs::path& directory) {
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(directory))
    files += entry.path().stem().string().starts_with("particles_") && entry.path().extension() == ".vtp" ? 1 : 0;
  return files;
}

/// Content of every file below a directory.
std::map<std::string, std::string> contents(const fs::path& directory) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file()) found[entry.path().string()] = read_text(entry.path());
  return found;
}

}  // namespace

TEST_CASE("Without --out every run gets a new directory, named after its case") {
  const Workplace place;
  for (int k = 0; k < 2; ++k) REQUIRE(place.gyrosim("run " + box + " --until '1 ms'").code == 0);
  CHECK(fs::exists(place.path() / "runs/box-001/summary.json"));
  CHECK(fs::exists(place.path() / "runs/box-002/summary.json"));
}

TEST_CASE("A run writes results, log, resolved case and summary, and the resolved case gives the same run") {
  const Workplace place;
  REQUIRE(place.gyrosim("run " + box + " --until '20 ms' --out a --set case.seed=7").code == 0);
  for (const char* name : {"results.h5", "summary.json", "log.txt", "case.yaml", "particles.pvd", "walls.pvd"})
    CHECK(fs::file_size(place.path() / "a" / name) > 0);
  CHECK(place.gyrosim("run a/case.yaml --until '20 ms' --out b").code == 0);
  for (const std::string name : {"ledger/kinetic", "series/max_overlap_ratio"})
    CHECK(result_of(place.path() / "a", name) == result_of(place.path() / "b", name));
  CHECK(read_text(place.path() / "a/case.yaml") == read_text(place.path() / "b/case.yaml"));
}

TEST_CASE("A finished run is not changed, and --overwrite starts it again") {
  const Workplace place;
  const std::string run = "run " + box + " --out r";
  REQUIRE(place.gyrosim(run + " --until '1 ms'").code == 0);
  const auto before = contents(place.path());
  const Outcome again = place.gyrosim(run + " --until '1 ms'");
  CHECK(again.code == 0);
  CHECK(again.err.find("finished") != std::string::npos);
  CHECK(contents(place.path()) == before);
  CHECK(place.gyrosim(run + " --overwrite --until '2 ms'").code == 0);
  CHECK(summary_of(place.path() / "r")["simulated_seconds"].get<double>() == Approx(0.002));
}

TEST_CASE("A run reaches the time of --until for any windows, in any unit and beyond the case's duration") {
  const Workplace place;
  int k = 0;
  for (const auto& [until, reached] : std::vector<std::pair<std::string, double>>{
           {"0.003", 3e-3}, {"'3 ms'", 3e-3}, {"'3200 us'", 3.5e-3}, {"'10.5 ms'", 10.5e-3}, {"0", 0}}) {
    const std::string name = std::to_string(++k);
    REQUIRE(place.gyrosim("run " + box + " --set 'time.duration=10 ms' --out " + name + " --until " + until).code == 0);
    const nlohmann::json summary = summary_of(place.path() / name);
    CHECK(summary["status"] == "done");
    CHECK(summary["simulated_seconds"].get<double>() == Approx(reached).margin(1e-12));
  }
}

TEST_CASE(
    "A signal ends a run after its window with closed files and exit code 75, and the next call asks what to do") {
  const std::string signal = GENERATE(as<std::string>{}, "TERM", "INT", "USR1", "HUP", "XCPU");
  const Workplace place;
  // Half a second after the run has its results file, however slow the machine is. The program takes the shell's place.
  CHECK(place
            .shell("sh -c '(until ls r/results.h5 > /dev/null 2>&1; do sleep 0.1; done; sleep 0.5; kill -" + signal +
                   " $$) & exec \"$GYROSIM\" \"$@\"' sh run " + endless + " --out r --quiet")
            .code == 75);
  const nlohmann::json summary = summary_of(place.path() / "r");
  CHECK(summary["status"] == "interrupted");
  CHECK(summary["reason"].get<std::string>().find("signal") != std::string::npos);
  const std::vector<double> time = result_of(place.path() / "r", "series/time");
  REQUIRE(!time.empty());
  CHECK(time.back() == Approx(summary["simulated_seconds"].get<double>()));

  const auto before = contents(place.path());
  const Outcome again = place.gyrosim("run " + box + " --out r");
  CHECK(again.code == 2);
  CHECK(again.err.find("--resume") != std::string::npos);
  CHECK(again.err.find("--overwrite") != std::string::npos);
  CHECK(contents(place.path()) == before);
  CHECK(place.gyrosim("run " + box + " --out r --overwrite --until '1 ms'").code == 0);
}

TEST_CASE("A signal that the caller ignores is ignored") {
  const Workplace place;
  place.write("nohup.sh", "trap '' HUP\n\"$@\" & sleep 0.5; kill -HUP $!; wait $!\n");
  CHECK(place.shell("sh nohup.sh $GYROSIM run " + endless + " --out r --quiet --max-walltime '1.5 s'").code == 75);
  CHECK(summary_of(place.path() / "r")["reason"] == "--max-walltime is over");
}

TEST_CASE("Closed standard streams do not damage the files of a run") {
  const Workplace place;
  CHECK(place.shell("$GYROSIM run " + box + " --out r --until '5 ms' <&- >&- 2>&-").code == 0);
  CHECK(result_of(place.path() / "r", "series/time").back() == Approx(5e-3));
}

TEST_CASE("A second run on a directory is refused and does not affect the first, also with --resume or --overwrite") {
  const Workplace place;
  const std::string second = GENERATE(as<std::string>{}, "", "--resume", "--overwrite");
  place.write("two.sh", "$GYROSIM run " + endless +
                            " --out r --quiet --max-walltime '2 s' & first=$!\n"
                            "while ! [ -s r/case.yaml ]; do sleep 0.02; done\n"
                            "$GYROSIM run " +
                            endless + " --out r " + second +
                            "; echo second $?\n"
                            "wait $first; echo first $?\n");
  const Outcome outcome = place.shell("sh two.sh");
  CHECK(outcome.out == "second 2\nfirst 75\n");
  CHECK(outcome.err.find("r: a run is still writing here (process ") != std::string::npos);
  CHECK(summary_of(place.path() / "r")["status"] == "interrupted");
  CHECK(!fs::exists(place.path() / "r/run.lock"));
}

TEST_CASE("A reader that closes the pipe of the summary does not end the run") {
  const Workplace place;
  CHECK(place.shell("{ $GYROSIM run " + box + " --out r --until '5 ms'; echo $? >&2; } | true").err.ends_with("5\n"));
  CHECK(summary_of(place.path() / "r")["status"] == "done");
}

TEST_CASE("The end of --max-walltime ends a run with exit code 75") {
  const Workplace place;
  CHECK(place.gyrosim("run " + endless + " --out r --max-walltime '0.5 s'").code == 75);
  CHECK(summary_of(place.path() / "r")["status"] == "interrupted");
  CHECK(summary_of(place.path() / "r")["reason"].get<std::string>().find("--max-walltime") != std::string::npos);
}

TEST_CASE("A run that the guard stops has exit code 4 and reports the reason") {
  const Workplace place;
  // A sphere so fast that it would pass another one within a step.
  place.write("two.csv", "id,x,y,z,r,vx,vy,vz\n1,0,0,0.05,0.01,0,0,0\n2,0.05,0,0.05,0.01,0,0,900\n");
  const Outcome outcome =
      place.gyrosim("run " + box + " --set particles.file=" + (place.path() / "two.csv").string() + " --out r");
  INFO(outcome.err);
  CHECK(outcome.code == 4);
  CHECK(summary_of(place.path() / "r")["status"] == "stopped");
  CHECK(summary_of(place.path() / "r")["reason"].get<std::string>().find("particle 2 moves by") != std::string::npos);
}

TEST_CASE("Standard output has only the summary, and with --quiet it is empty") {
  const Workplace place;
  const Outcome loud = place.gyrosim("run " + box + " --until '1 ms' --out a");
  CHECK(loud.out.find("done") != std::string::npos);
  CHECK(loud.err.find("results in a") != std::string::npos);
  const Outcome quiet = place.gyrosim("run " + box + " --until '1 ms' --out b --quiet");
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
}

TEST_CASE("A run whose snapshots cannot be written any more ends with that reason") {
  const Workplace place;
  const Outcome outcome = place.shell("\"$GYROSIM\" run " + box +
                                      " --set 'time.duration=10 h' --set 'output.snapshots=5 ms' --set "
                                      "output.checkpoints=0 --out r --max-walltime '60 s' & run=$!; " +
                                      moved_away);
  CHECK(outcome.code == 5);
  INFO(outcome.err);
  CHECK(outcome.err.find("r/snapshots/particles_") != std::string::npos);
  CHECK(outcome.err.find("No such file or directory") != std::string::npos);
  const nlohmann::json summary = summary_of(place.path() / "r");
  CHECK(summary["status"] == "failed");
  CHECK(outcome.err.find(summary["reason"].get<std::string>()) != std::string::npos);
  CHECK_FALSE(fs::exists(place.path() / "r/checkpoint.h5"));
  // The index names the frames that were written.
  const std::size_t frames = frames_in(place.path() / "r/particles.pvd");
  CHECK(frames >= 3);
  CHECK(frames == particle_files(place.path() / "away"));
}

TEST_CASE("A checkpoint never counts a frame that is not in the directory") {
  const Workplace place;
  // A checkpoint after each window, also after the one whose frame cannot be written.
  const std::string run =
      "\"$GYROSIM\" run " + box + " --set 'output.snapshots=5 ms' --set 'output.checkpoints=1 ms' --out r ";
  const Outcome outcome = place.shell(run + "--set 'time.duration=10 h' --max-walltime '60 s' & run=$!; " + moved_away);
  INFO(outcome.err);
  REQUIRE(outcome.code == 5);
  REQUIRE(fs::exists(place.path() / "r/checkpoint.h5"));
  fs::remove_all(place.path() / "r/snapshots");  // if the run has made it again
  fs::rename(place.path() / "away", place.path() / "r/snapshots");
  const double end = summary_of(place.path() / "r")["simulated_seconds"].get<double>() + 0.02;
  const Outcome resumed = place.shell(run + "--resume --until " + std::to_string(end));
  INFO(resumed.err);
  REQUIRE(resumed.code == 0);
  const std::size_t frames = frames_in(place.path() / "r/particles.pvd");
  const double reached = summary_of(place.path() / "r")["simulated_seconds"].get<double>();
  CHECK(frames == static_cast<std::size_t>(reached / 5e-3 + 1e-6) + 1);
  CHECK(frames == particle_files(place.path() / "r/snapshots"));
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::string number = std::to_string(frame);
    const std::string name = "particles_" + std::string(6 - number.size(), '0') + number + ".vtp";
    CHECK(fs::exists(place.path() / "r/snapshots" / name));
    CHECK_THAT(read_text(place.path() / "r/particles.pvd"), Catch::Matchers::Contains(name));
  }
}
