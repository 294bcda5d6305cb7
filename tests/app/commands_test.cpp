// SPDX-License-Identifier: GPL-3.0-or-later
// Commands other than run.
#include "io/hdf5/hdf5.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>

namespace {

using namespace gyro;
using nlohmann::json;

const std::string platen = "'" GYRO_APP_CASES "/platen.yaml'", crush = "'" GYRO_APP_CASES "/crush.yaml'";

/// Standard output of a call that must succeed, as one JSON document.
json document(const Workplace& place, const std::string& arguments) {
  const Outcome outcome = place.gyrosim(arguments);
  INFO(arguments << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  return json::parse(outcome.out);
}

}  // namespace

TEST_CASE("check --json reports the size and cost of a case") {
  const Workplace place;
  const json j = document(place, "check " + platen + " --json");
  CHECK(j["valid"] == true);
  CHECK(j["problems"].empty());
  const double step = j["time_step"], limit = j["time_step_limit"];
  CHECK(step > 0);
  CHECK(step <= 0.7 * limit);
  CHECK(j["steps"].get<double>() * j["hold"].get<double>() == Approx(0.05));
  CHECK(j["hold"].get<double>() == Approx(j["substeps"][1].get<double>() * step));
  CHECK(j["limited_by"].get<std::string>().find("rock") != std::string::npos);
  CHECK(j["bytes"] > 0);
  CHECK(j["estimated_seconds"] > 0);
  CHECK(place.listing().empty());

  // The counts of check are those of the run.
  REQUIRE(place.gyrosim("run " + platen + " --until '0.5 ms' --out r").code == 0);
  const json summary = summary_of(place.path() / "r");
  CHECK(summary["particles"] == j["particles"]);
  CHECK(summary["bonds_initial"] == j["bonds"]);
  CHECK(summary["time_step"] == j["time_step"]);
  CHECK(summary["time_step_limit"] == j["time_step_limit"]);
}

TEST_CASE("check --json of a bad case is one document too, with exit code 2") {
  const Workplace place;
  for (const std::string set : {"materials.rock.density=-1", "'time.step=10 us'", "'feed.at=[0,0,0]'"}) {
    const Outcome outcome = place.gyrosim("check " + platen + " --json --set " + set);
    CHECK(outcome.code == 2);
    const json j = json::parse(outcome.out);
    CHECK(j["valid"] == false);
    REQUIRE(j["problems"].size() == 1);
    CHECK(j["problems"][0]["line"] >= 1);
    CHECK(j["problems"][0]["message"].get<std::string>().find("; ") != std::string::npos);
  }
}

TEST_CASE("check in words names step, limit, counts, memory and time") {
  const Outcome outcome = Workplace().gyrosim("check " + platen);
  REQUIRE(outcome.code == 0);
  for (const char* word : {"duration:", "step ", "limit ", "steps ", "particles ", "bonds ", "memory ", "wall time "})
    CHECK(outcome.out.find(word) != std::string::npos);
}

TEST_CASE("library --json lists every rock, with the same values in every call") {
  const Workplace place;
  const json first = document(place, "library " + crush + " --json"),
             second = document(place, "library " + crush + " --json");
  REQUIRE(first["rocks"].size() == 3);
  CHECK(first["rocks"] == second["rocks"]);
  for (const json& rock : first["rocks"]) {
    CHECK(rock["particles"] > 10);
    CHECK(rock["bonds"] > rock["particles"]);
    CHECK(rock["diameter"] > 0.028);
    CHECK(rock["diameter"] < 0.045);
    CHECK(std::abs(rock["mass_error"].get<double>()) < 0.005);
    CHECK(rock["critical_step"] > 0);
    CHECK(rock["packing_fraction"] > 0.5);
  }
}

TEST_CASE("library --out writes every rock, and a picture") {
  const Workplace place;
  const json j = document(place, "library " + crush + " --out l --json");
  CHECK(place.listing() == std::vector<std::string>{"l", "l/bonds.pvd", "l/library.h5", "l/particles.pvd",
                                                    "l/snapshots", "l/snapshots/bonds_000000.vtp",
                                                    "l/snapshots/particles_000000.vtp"});
  const hdf5::File file = hdf5::File::open(place.path() / "l/library.h5");
  CHECK(file.children("/rocks").size() == 3);
  for (const json& rock : j["rocks"]) {
    const std::string group = "/rocks/" + rock["name"].get<std::string>();
    CHECK(file.dataset(group + "/centres").rows() == rock["particles"].get<int>());
    CHECK(file.dataset(group + "/centres").columns() == 3);
    CHECK(file.dataset(group + "/bonds").rows() == rock["bonds"].get<int>());
    CHECK(file.number_attribute(group, "diameter") == rock["diameter"].get<double>());
    const std::vector<double> centres = file.dataset(group + "/centres").read(),
                              pairs = file.dataset(group + "/bonds").read();
    const auto i = static_cast<std::size_t>(3 * pairs[0]), k = static_cast<std::size_t>(3 * pairs[1]);
    const double distance =
        std::hypot(centres[i] - centres[k], centres[i + 1] - centres[k + 1], centres[i + 2] - centres[k + 2]);
    CHECK(file.dataset(group + "/bond_length").read()[0] == Approx(distance).epsilon(1e-6));
  }
}

TEST_CASE("liners --json measures the setting of the case") {
  const Workplace place;
  const json j = document(place, "liners " + crush + " --out l --json");
  CHECK(j["closed_side_setting"].get<double>() == Approx(0.015).margin(1e-6));
  CHECK(j["throw"].get<double>() == Approx(2 * 2.7125e-3).epsilon(0.03));
  CHECK(j["open_side_setting"].get<double>() - j["closed_side_setting"].get<double>() ==
        Approx(j["throw"].get<double>()));
  CHECK(j["measured_on_meshes"]["closed"].get<double>() == Approx(0.015).margin(1e-4));
  CHECK(j["measured_on_meshes"]["open"] == Approx(j["open_side_setting"].get<double>()).margin(1e-4));
  CHECK(j["volume"] > 0);
  CHECK(j["capacity_tph"] > 0);
  CHECK(j["nip_angle"].size() > 2);
  CHECK(place.listing() == std::vector<std::string>{"l", "l/concave.stl", "l/mantle.stl"});
}

TEST_CASE("A feed of less than a rock and a drive without a wall to move are refused") {
  const Workplace place;
  const std::string drive =
      "'drivetrain={motor: {model: constant_speed, speed: 100}, gear_ratio: 1, inertia: {eccentric: 1}}' "
      "--set 'crusher={closed_side_setting: 0.1, eccentricity: 0.01, pivot_height: 1}'";
  for (const std::string& word : {std::string("lightest rock"), std::string("no wall gyrates")}) {
    const std::string set =
        word == "lightest rock" ? crush + " --set feed.initial=1e-4" : "'" GYRO_CASES "/box.yaml' --set " + drive;
    for (const std::string command : {"check ", "run --out r "}) {
      const Outcome outcome = place.gyrosim(command + set);
      INFO(outcome.err);
      CHECK(outcome.code == 2);
      CHECK(outcome.err.find(word) != std::string::npos);
    }
  }
  CHECK(place.listing().empty());
}

TEST_CASE("Standard output that cannot be written is an output error") {
  const Workplace place;
  for (const std::string command : {"describe", "init", "info --json", "check '" GYRO_CASES "/box.yaml' --json"})
    CHECK(place.gyrosim(command + " >/dev/full 2>/dev/null #").code == 5);
}

TEST_CASE("describe, init and info") {
  const Workplace place;
  CHECK(place.gyrosim("describe").out.find("crusher.closed_side_setting") != std::string::npos);
  CHECK(json::parse(place.gyrosim("describe --json-schema").out).contains("properties"));
  CHECK(place.gyrosim("--version").out.find("gyrosim ") == 0);
  const json info = document(place, "info --json");
  for (const char* key : {"version", "git", "cuda", "libraries", "cpu", "threads"}) CHECK(info.contains(key));
  for (const json& version : info["libraries"]) CHECK(!version.get<std::string>().empty());
  for (const std::string name : {"quickstart", "primary", "compression"}) {
    const Outcome outcome = place.gyrosim("init --template " + name);
    CHECK(outcome.code == 0);
    CHECK(outcome.out.find("bonds:") != std::string::npos);
  }
}
