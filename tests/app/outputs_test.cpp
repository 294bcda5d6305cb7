// SPDX-License-Identifier: GPL-3.0-or-later
// The reference of outputs against what runs write.
#include "io/hdf5/hdf5.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <map>
#include <set>

namespace {

using namespace gyro;
using nlohmann::json;
namespace fs = std::filesystem;

const std::string quickstart = "'" GYRO_CASES "/quickstart.yaml'", box = "'" GYRO_CASES "/box.yaml'";

/// Entries of `describe outputs --json`.
json reference(const Workplace& place) {
  const Outcome outcome = place.gyrosim("describe outputs --json");
  REQUIRE(outcome.code == 0);
  return json::parse(outcome.out)["outputs"];
}

std::string path_of(const json& entry) {
  return entry["group"].get<std::string>() + "/" + entry["name"].get<std::string>();
}

/// Whether a path of a file is described by a pattern such as "/liners/<wall>/work".
/// @param name  set to the part of the path that stands for <...>
bool fits(const std::string& path, const std::string& pattern, std::string& name) {
  const std::size_t open = pattern.find('<');
  if (open == std::string::npos) return path == pattern;
  const std::string before = pattern.substr(0, open), after = pattern.substr(pattern.find('>') + 1);
  if (path.size() <= before.size() + after.size() || !path.starts_with(before) || !path.ends_with(after)) return false;
  name = path.substr(before.size(), path.size() - before.size() - after.size());
  return name.find('/') == std::string::npos;
}

/// Paths of all datasets below a group.
std::vector<std::string> datasets(const hdf5::File& file, const std::string& group) {
  std::vector<std::string> all;
  for (const std::string& child : file.children(group)) {
    const std::string path = (group == "/" ? "" : group) + "/" + child;
    if (!file.is_group(path))
      all.push_back(path);
    else
      for (const std::string& below : datasets(file, path)) all.push_back(below);
  }
  return all;
}

std::string filled(std::string text, const std::string& name) {
  const std::size_t open = text.find('<');
  return open == std::string::npos ? text : text.replace(open, text.find('>') - open + 1, name);
}

bool once(const json& entry) {
  return entry["description"].get<std::string>().ends_with("written once");
}

void require_as_described(const hdf5::Dataset& dataset, const json& entry, const std::string& name) {
  CHECK(dataset.string_attribute("units") == entry["units"]);
  CHECK(dataset.string_attribute("sampling") == entry["sampling"]);
  CHECK(dataset.string_attribute("description") == filled(entry["description"], name));
  if (once(entry))
    CHECK(dataset.rows() > 1);
  else if (entry["width"] == "1" || entry["width"] == "3")
    CHECK(std::to_string(dataset.columns()) == entry["width"]);
  else
    CHECK(dataset.columns() > 1);
}

/// Matches every dataset of a run with one entry. @returns paths of the entries that were found
std::set<std::string> described(const fs::path& run, const json& entries) {
  const hdf5::File file = hdf5::File::open(run / "results.h5");
  std::set<std::string> found;
  for (const std::string& path : datasets(file, "/")) {
    INFO(path);
    int matches = 0;
    for (const json& entry : entries) {
      std::string name;
      if (!fits(path, path_of(entry), name)) continue;
      ++matches;
      found.insert(path_of(entry));
      require_as_described(file.dataset(path), entry, name);
    }
    CHECK(matches == 1);
  }
  return found;
}

}  // namespace

TEST_CASE("The reference describes every dataset of a quickstart run, and every described dataset exists") {
  const Workplace place;
  const Outcome outcome =
      place.gyrosim("run " + quickstart +
                    " --until '3 ms' --out r --set 'output.probes=[0]' --set 'output.liners={interval: "
                    "1 ms, rows: 4, sectors: 6, wear_coefficient: 1e-12}' --set 'output.fines={breakage: {A: 0.6, b: 8 "
                    "t/kWh}}' --set 'numerics.levels={rigid: rocks}'");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const json entries = reference(place);
  const std::set<std::string> found = described(place.path() / "r", entries);
  const json summary = summary_of(place.path() / "r");
  const hdf5::File file = hdf5::File::open(place.path() / "r/results.h5");
  std::set<std::string> members;
  for (const json& entry : entries) {
    const std::string name = entry["name"], group = entry["group"];
    INFO(group << " " << name);
    CHECK(!entry["description"].get<std::string>().empty());
    if (group == "summary.json") {
      members.insert(name);
      if (name.find('.') == std::string::npos) CHECK(summary.contains(name));
    } else if (group == "/case") {
      CHECK((name == "seed" || !file.string_attribute("/case", name).empty()));
    } else if (entry["sampling"] == "attribute") {
      CHECK(file.number_attribute(group, name) > 0);
    } else if (group.starts_with("/")) {
      CHECK(found.count(path_of(entry)) == 1);
    }
  }
  for (const auto& [name, value] : summary.items()) {
    INFO(name);
    CHECK(members.count(name) == 1);
  }
}

TEST_CASE("A scene without most parts has only the outputs that are described as always present") {
  const Workplace place;
  REQUIRE(place.gyrosim("run " + box + " --until '20 ms' --out r").code == 0);
  const json entries = reference(place);
  const std::set<std::string> found = described(place.path() / "r", entries);
  for (const json& entry : entries) {
    const std::string path = path_of(entry);
    INFO(path);
    if (!path.starts_with("/") || path.starts_with("/case") || path.find("<id>") != std::string::npos) continue;
    CHECK((found.count(path) == 1) == (entry["when"] == "always"));
  }
}

TEST_CASE("Powers, torques, forces and rates of the series are means, speeds, angles, masses and counts are instants") {
  const std::map<std::string, std::string> rule{
      {"W", "mean"},     {"N m", "mean"},  {"N", "mean"},    {"kg/s", "mean"}, {"rad/s", "instant"}, {"rad", "instant"},
      {"kg", "instant"}, {"1", "instant"}, {"s", "instant"}, {"m", "instant"}, {"m/s", "instant"}};
  const Workplace place;
  int count = 0;
  for (const json& entry : reference(place)) {
    if (entry["group"] != "/series") continue;
    INFO(entry["name"]);
    CHECK(rule.at(entry["units"]) == entry["sampling"]);
    ++count;
  }
  CHECK(count > 20);
}

TEST_CASE("The page of outputs is the one that the program writes") {
  const Workplace place;
  const Outcome page = place.gyrosim("describe outputs --markdown");
  REQUIRE(page.code == 0);
  INFO("gyrosim describe outputs --markdown > cases/OUTPUTS.md");
  CHECK((page.out == read_text(GYRO_CASES "/OUTPUTS.md")));
  const Outcome text = place.gyrosim("describe outputs");
  CHECK(text.out.find("/series/motor_speed\n    rad/s, instant; with a drivetrain") != std::string::npos);
  CHECK(place.gyrosim("describe --json").code == 2);
  CHECK(place.gyrosim("describe time.step --markdown").code == 2);
}
