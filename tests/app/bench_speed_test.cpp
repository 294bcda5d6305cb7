// SPDX-License-Identifier: GPL-3.0-or-later
// `gyrosim bench speed`: its start states, its measurement, and its shape against what is documented.
#include "app/bench/speed/own_process.hpp"
#include "app/bench/speed/report.hpp"
#include "app/bench/speed/state_files.hpp"
#include "core/base/errors.hpp"
#include "core/rocks/bonds.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <fstream>
#include <set>

using namespace gyro;
using namespace gyro::bench;
namespace fs = std::filesystem;

namespace {

/// @param particles  0: as many as usual
SpeedScene with_particles(const std::string& name, int particles) {
  SpeedScene scene = scene_named(name);
  if (particles > 0) scene.recipe.particles = particles;
  return scene;
}

StartState small(const std::string& name, std::uint64_t seed = 7) {
  const SpeedScene scene = with_particles(name, 1000);
  return scene.make({seed, 1000});
}

double lowest(const StartState& s) {
  double z = 1;
  for (std::size_t k = 0; k < s.centres.size(); ++k) z = std::min(z, s.centres[k].z - s.radii[k]);
  return z;
}

}  // namespace

TEST_CASE("Close pairs of the bench are those that a search of all pairs finds") {
  const StartState s = small("S1");
  const double gap = 0.004;
  std::vector<std::pair<Index, Index>> all, found;
  for (std::size_t i = 0; i < s.centres.size(); ++i)
    for (std::size_t j = i + 1; j < s.centres.size(); ++j)
      if (norm(s.centres[j] - s.centres[i]) < s.radii[i] + s.radii[j] + gap) all.emplace_back(i, j);
  for (const auto& [i, j] : close_pairs(s.centres, s.radii, gap)) found.emplace_back(i, j);
  CHECK(found == all);
  CHECK(all.size() > s.centres.size());
}

TEST_CASE("Start states of the bench overlap nowhere, and follow from seed and number") {
  for (const char* name : {"S1", "S2", "S2r", "S3"}) {
    CAPTURE(name);
    const StartState s = small(name), same = small(name), other = small(name, 8);
    REQUIRE(s.centres.size() == (std::string(name) == "S2r" ? 7u * 136 : 1000u));
    REQUIRE(s.radii.size() == s.centres.size());
    CHECK(smallest_room(s.centres, s.radii) > 1 - 1e-12);
    CHECK(smallest_room(s.centres, s.radii) < 1.001);  // but it is tight
    double moved = 0;
    for (std::size_t k = 0; k < s.centres.size(); ++k) {
      CHECK(norm(s.centres[k] - same.centres[k]) == 0);
      moved = std::max(moved, norm(s.centres[k] - other.centres[k]));
    }
    CHECK(moved > 1e-3);
  }
}

TEST_CASE("Spheres of the bench lie inside their walls, packed as loose rock is") {
  const StartState box = small("S1");
  const double width = box.sizes.at(0).second;
  CHECK(width == Approx(0.8 * std::cbrt(1000 / 20000.0)));
  double volume = 0;
  for (std::size_t k = 0; k < box.centres.size(); ++k) {
    const Vec3d x = box.centres[k];
    const double r = box.radii[k];
    CHECK(std::min({x.x - r, x.y - r, width - x.x - r, width - x.y - r, x.z - r}) >= 0);
    volume += 4.18879 * r * r * r;
  }
  CHECK(volume / (width * width * box.sizes.at(1).second) > 0.5);
  const StartState cones = small("S3");
  CHECK(lowest(cones) > 0);
  CHECK(cones.meshes.size() == 2);
  for (const auto& [name, mesh] : cones.meshes) CHECK(mesh.triangles.size() == 2304);
}

TEST_CASE("Plates of the bench touch the bonded spheres, and its rocks hold together") {
  for (const char* name : {"S2", "S2r"}) {
    CAPTURE(name);
    const StartState s = small(name);
    CHECK(s.sizes.at(0).first == "bottom");
    CHECK(lowest(s) == Approx(s.sizes.at(0).second).margin(1e-15));
    CHECK(2.0 * static_cast<double>(s.bonds.size()) > 4.5 * static_cast<double>(s.centres.size()));
    for (const auto& [i, j] : s.bonds) CHECK(norm(s.centres[j] - s.centres[i]) < 0.0215);
  }
  const StartState rocks = small("S2r");
  std::vector<TemplateBond> bonds;
  for (const auto& [i, j] : rocks.bonds) {
    REQUIRE(i / 136 == j / 136);
    if (i < 136) bonds.push_back({i, j, 0.02, 0.005});
  }
  CHECK(largest_piece(bonds, 136).size() == 136);
}

TEST_CASE("A process of its own gives results and errors back") {
  CHECK(in_own_process([] { return nlohmann::json{{"n", 3}}; }).at("n") == 3);
  CHECK_THROWS_AS(in_own_process([]() -> nlohmann::json { throw BadInput("no such thing"); }), BadInput);
  CHECK_THROWS_AS(in_own_process([]() -> nlohmann::json { throw StoppedByGuard("too fast"); }), StoppedByGuard);
  CHECK_THROWS_AS(in_own_process([]() -> nlohmann::json { throw std::bad_alloc(); }), NoDevice);
  CHECK_THROWS_AS(in_own_process([]() -> nlohmann::json {
                    std::raise(SIGKILL);
                    return {};
                  }),
                  NoDevice);
}

TEST_CASE("A measurement has the same energies on two threads, and counts what it says") {
  const ScratchDirectory folder;
  SpeedScene scene = with_particles("S2r", 2 * 136);
  scene.warm_up = 10, scene.timed = 40;
  const std::vector<SpeedResult> results =
      measure(scene, {.cases = GYRO_CASES, .states = folder.path(), .precisions = {Precision::double_}, .repeat = 3});
  REQUIRE(results.size() == 2);
  REQUIRE(results[0].runs.size() == 3);
  const SpeedMeasurement &one = results[0].median(), &two = results[1].median();
  CHECK(one.kinetic == two.kinetic);
  CHECK(one.kinetic > 0);
  CHECK(one.steps == 40);
  CHECK(one.particles == 2 * 136);
  CHECK(one.bond_steps == 40 * one.bonds);
  CHECK(one.contacts >= 4);  // each rock on both plates
  CHECK(one.bytes > 0);
  CHECK(results[0].runs.front().cpu_seconds <= results[0].runs.back().cpu_seconds);
  const nlohmann::ordered_json j = to_json(results[0]);
  double shares = 0;
  for (const auto& [name, share] : j.at("phases").items()) shares += share.get<double>();
  CHECK(shares == Approx(1));
  CHECK(j.at("phases").contains("advance rocks"));
  CHECK(j.at("spread").at(0) <= j.at("particle_steps_per_second"));
}

TEST_CASE("bench speed writes start states that run, and measures them") {
  const Workplace place;
  const Outcome written = place.gyrosim("bench speed --scene S3 --particles 1000 --seed 3 --states s --states-only");
  REQUIRE(written.code == 0);
  CHECK(written.out.find("S3-3-1000") != std::string::npos);
  for (const char* file : {"particles.csv", "outer.stl", "inner.stl", "case.yaml", "scene.json"})
    CHECK(fs::exists(place.path() / "s/S3-3-1000" / file));
  CHECK(place.gyrosim("check s/S3-3-1000/case.yaml").code == 0);
  const Outcome measured = place.gyrosim(
      "bench speed --scene S3 --particles 1000 --seed 3 --states s --warm-up 20 --steps 100 --precision mixed "
      "--threads "
      "1 --json");
  REQUIRE(measured.code == 0);
  const nlohmann::json j = nlohmann::json::parse(measured.out);
  REQUIRE(j.at("scenes").size() == 1);
  CHECK(j.contains("machine"));
  for (const char* key : {"scene", "threads", "particles", "bonds", "steps", "substeps", "precision", "seconds",
                          "particle_steps_per_second", "bond_steps_per_second", "contact_evaluations_per_second",
                          "simulated_seconds_per_hour", "bytes_per_particle", "setup_seconds", "rebuilds", "phases"})
    CHECK(j.at("scenes").at(0).contains(key));
  CHECK(j.at("scenes").at(0).at("steps") == 100);
}

TEST_CASE("Start states are kept for the same scene, and made again for another number of steps") {
  const ScratchDirectory folder;
  SpeedScene scene = with_particles("S2r", 136);
  const fs::path file = write_start(scene, GYRO_CASES, folder.path()), table = file.parent_path() / "particles.csv";
  const std::string rows = read_text(table);
  std::ofstream(table) << "mark";
  write_start(scene, GYRO_CASES, folder.path());
  CHECK(read_text(table) == "mark");
  scene.timed += 1;
  write_start(scene, GYRO_CASES, folder.path());
  CHECK(read_text(table) == rows);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they take memory of their own
TEST_CASE("Bonded rock takes little memory, set-up included") {
  const ScratchDirectory folder;
  const SpeedScene scene = with_particles("S2r", 0);
  SpeedRun run{.file = write_start(scene, GYRO_CASES, folder.path()), .warm_up = 2, .timed = 2};
  run.precision = Precision::mixed;
  const SpeedMeasurement m = measurement_of(in_own_process([&] { return to_json(measure_speed(run)); }));
  CHECK(m.particles == scene.recipe.particles);
  // About 1100 on the machine of tests/bench, of which 250 are the pages of the program that a run touches.
  const auto bytes = static_cast<double>(m.bytes) / static_cast<double>(m.particles);
  CHECK(bytes > 500);
  CHECK(bytes < 1500);
}
#endif

TEST_CASE("Scenes without a start state are measured in windows") {
  SpeedRun run{.file = fs::path(GYRO_CASES) / "box.yaml", .timed = 30};
  const auto steps = [&] { return in_own_process([&] { return to_json(measure_speed(run)); }).at("steps").get<int>(); };
  CHECK(steps() == 30);
  run.whole_windows = true;
  run.timed = 30;  // windows of several steps
  CHECK(steps() > 30);
}

TEST_CASE("bench speed says what it cannot measure") {
  const Workplace place;
  const Outcome unknown = place.gyrosim("bench speed --scene S9");
  CHECK(unknown.code == 2);
  CHECK(unknown.err.find("S1, S2, S2r, S3, Q, C, F") != std::string::npos);
  CHECK(place.gyrosim("bench speed --scene Q --seed 4").code == 2);
  CHECK(place.gyrosim("bench speed --states-only").code == 2);
  const Outcome key = place.gyrosim("bench speed --scene S1 --particles 1000 --set numerics.nonsense=1");
  CHECK(key.code == 2);
  CHECK(key.err.find("nonsense") != std::string::npos);
  const Outcome mass = place.gyrosim("bench speed --scene Q --threads 1 --precision mixed --set 'feed.initial=900 kg'");
  CHECK(mass.code == 2);
  CHECK(mass.err.find("quickstart.yaml:38:1: the initial charge") != std::string::npos);
  CHECK(place.listing().empty());
}
