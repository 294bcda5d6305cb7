// SPDX-License-Identifier: GPL-3.0-or-later
// Bad usage and bad input: exit code 2, a message that says where and what to do, nothing written.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <unistd.h>
#include <algorithm>
#include <regex>

namespace {

using namespace gyro;

const std::string platen = "'" GYRO_APP_CASES "/platen.yaml'";

/// Every line is FILE:LINE:COLUMN: problem; what to do.
bool all_located(const std::string& text) {
  const std::regex form("[^\n]+:[0-9]+:[0-9]+: [^\n]+; [^\n]+");
  std::istringstream lines(text);
  int count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    if (!std::regex_match(line, form)) return false;
  return count > 0;
}

}  // namespace

TEST_CASE("Broken case files of all kinds are refused by run and check, and no file is written") {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(GYRO_BROKEN_CASES))
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  REQUIRE(files.size() >= 25);
  const Workplace place;
  for (const std::filesystem::path& file : files) {
    INFO(file);
    for (const std::string command : {"run ", "check "}) {
      const Outcome outcome = place.gyrosim(command + "'" + file.string() + "'");
      INFO(outcome.err);
      CHECK(outcome.code == 2);
      CHECK(all_located(outcome.err));
      CHECK(outcome.out.empty());
    }
  }
  CHECK(place.listing().empty());
}

TEST_CASE("A problem found when the case is assembled is reported with its place, and no file is written") {
  const auto [arguments, where, what] = GENERATE(table<std::string, std::string, std::string>({
      {"--set 'time.step=10 us'", "--set:1:1: ", "stability limit"},
      {"--set 'feed.at=[0, 0, 0.005]'", "platen.yaml:21:1: ", "fixed rock"},
      {"--set walls.lower.plane=null --set walls.lower.stl=bad.stl", "platen.yaml:23:3: ", "bad.stl"},
      {"--set walls.lower.plane=null --set walls.lower.stl=none.stl", "--set:2:1", "none.stl"},
  }));
  const Workplace place;
  std::filesystem::copy(GYRO_APP_CASES "/platen.yaml", place.path());
  place.write("bad.stl", "solid nothing\n");
  const std::vector<std::string> before = place.listing();
  for (const std::string command : {"run ", "check "}) {
    const Outcome outcome = place.gyrosim(command + "platen.yaml " + arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK(all_located(outcome.err));
    CHECK(outcome.err.find(where) != std::string::npos);
    CHECK(outcome.err.find(what) != std::string::npos);
    CHECK(outcome.out.empty());
  }
  CHECK(place.listing() == before);
}

TEST_CASE("A bad command line is refused with advice") {
  const std::string arguments = GENERATE(
      as<std::string>{}, "", "crush x.yaml", "run", "run " + platen + " --bogus", "run " + platen + " --threads 0",
      "run " + platen + " --threads two", "run " + platen + " --device gpu", "run " + platen + " --until '2 kg'",
      "run " + platen + " --until -1", "run " + platen + " --max-walltime soon", "run " + platen + " --set time",
      "run " + platen + " --out " + platen, "run " + platen + " --resume", "run " + platen + " --overwrite",
      "run " + platen + " --out r --overwrite --resume", "run nowhere.yaml", "run .", "describe time.durat",
      "init --template secondary", "liners " + platen + " --out l", "liners " + platen,
      "library '" GYRO_CASES "/box.yaml'");
  INFO(arguments);
  const Workplace place;
  const Outcome outcome = place.gyrosim(arguments);
  INFO(outcome.err);
  CHECK(outcome.code == 2);
  CHECK(outcome.out.empty());
  CHECK(std::regex_search(outcome.err, std::regex("; |not in ")));
  CHECK(place.listing().empty());
}

TEST_CASE("A directory that cannot be created is an output error") {
  const Workplace place;
  for (const std::string& command :
       {"run " + platen + " --until '1 ms'", std::string("liners '" GYRO_APP_CASES "/crush.yaml'")}) {
    const Outcome outcome = place.gyrosim(command + " --out /proc/gyrosim");
    INFO(outcome.err);
    CHECK(outcome.code == 5);
    CHECK(outcome.err.find("/proc/gyrosim") != std::string::npos);
  }
}

#if !defined(GYRO_WITH_CUDA)
TEST_CASE("A missing device is reported, and no file is written") {
  const Workplace place;
  const Outcome outcome = place.gyrosim("run " + platen + " --device cuda");
  CHECK(outcome.code == 6);
  CHECK(outcome.err.find("--device cpu") != std::string::npos);
  CHECK(place.listing().empty());
}
#endif
