// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs that cannot be meant: refused at once with the one cause, or noted with the key that corrects them.
#include "io/mesh/stl.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <sys/stat.h>
#include <chrono>
#include <cmath>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

const std::string quickstart = "'" GYRO_CASES "/quickstart.yaml'", box = "'" GYRO_CASES "/box.yaml'";

/// A closed block of these edges.
TriangleMesh block(double a, double b, double c) {
  TriangleMesh mesh;
  for (int k = 0; k < 8; ++k) mesh.vertices.push_back({k & 1 ? a : 0, k & 2 ? b : 0, k & 4 ? c : 0});
  const int faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& f : faces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// Options that add a wall from a mesh to box.yaml.
std::string wall(const std::string& more) {
  return " --set walls.extra=\"{stl: $PWD/block.stl, material: steel" + more + "}\"";
}

std::string notes_of(const Outcome& checked) {
  INFO(checked.err);
  REQUIRE(checked.code == 0);
  return nlohmann::json::parse(checked.out)["notes"].dump();
}

void check_refused(const Workplace& place, const std::string& arguments, const std::string& reason) {
  INFO(arguments);
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = place.gyrosim(arguments);
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  CHECK(outcome.code == 2);
  CHECK_THAT(outcome.err, Contains(reason));
  CHECK(passed.count() < 30);  // 0.1 s on a quiet machine
}

}  // namespace

TEST_CASE("Times that cannot be are refused with the one to change") {
  const Workplace place;
  check_refused(place, "run " + box + " --until '1e300 s' --out made", "--until: the run has");
  CHECK(!std::filesystem::exists(place.path() / "made"));
  check_refused(place, "check " + box + " --set output=null --set coupling.interval='1e-300 s'",
                "lengthen coupling.interval");
  check_refused(place, "check " + box + " --set time.step='1e-300 s'", "lengthen time.step");
  check_refused(place, "check " + box + " --set output.series='1e-300 s'", "shorter than coupling.interval");
  // What the case leaves out follows a longer coupling interval.
  const Outcome longer = place.gyrosim("check " + box + " --set output=null --set coupling.interval='2 ms'");
  CHECK(longer.code == 0);
  CHECK_THAT(longer.out, Contains("series: 0.002"));
}

TEST_CASE("Walls that nothing touches, or smaller than a particle, are noted with the keys to check") {
  const Workplace place;
  write_stl((place.path() / "block.stl").string(), block(0.1, 0.1, 0.1));
  const auto notes = [&](const std::string& more) {
    return notes_of(place.gyrosim("check " + box + " --json" + wall(more)));
  };
  CHECK_THAT(notes(", shift: [500 m, 0, 0]"), Contains("from all rock, so that nothing touches it; check shift"));
  CHECK_THAT(notes(", shift: [0, 0, 500 m]"), Contains("from all rock"));
  CHECK_THAT(notes(", shift: [0, 0, -0.5 m]"), !Contains("from all rock"));  // rock falls so far
  CHECK_THAT(notes(", shift: [0, 0, -0.5 m], scale: 0.01"), Contains("smaller than the smallest particle"));
  check_refused(place, "check " + box + wall(", scale: 1e-200"), "smaller than 0.01 mm");
  check_refused(place, "check " + box + wall(", scale: 1e6"), "larger than 1 km");
}

TEST_CASE("A profile drawn in other units is refused or noted") {
  const Workplace place;
  const std::string header = "z_m,mantle_radius_m,concave_radius_m\n";
  place.write("mm.csv", header + "0,119,137\n400,44,240\n");
  check_refused(place, "check " + quickstart + " --set crusher.profile=\"$PWD\"/mm.csv",
                "divide numbers in mm by 1000");
  place.write("dm.csv", header + "0,11.9,13.7\n40,4.4,24\n");
  check_refused(place, "check " + quickstart + " --set crusher.profile=\"$PWD\"/dm.csv",
                "pivot_height and profile are in metres");
}

TEST_CASE("Scans of rock that are needles or plates are refused with the name, without a search") {
  const Workplace place;
  const double thickness = GENERATE(1e-2, 1e-4);
  write_stl((place.path() / "scan.stl").string(),
            thickness > 1e-3 ? block(10, thickness, thickness) : block(1, 1, 1e-6));
  check_refused(place, "library " + quickstart + " --set rocks.shapes=\"{files: [$PWD/scan.stl]}\"",
                "scan: the shape is a needle or a plate");
}

TEST_CASE("A particle a thousand times smaller than another costs no time") {
  const Workplace place;
  place.write("sizes.csv", "id,x,y,z,r\n1,0,0,0.0005,1e-6\n2,0.01,0,0.1,0.01\n");
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = place.gyrosim("check " + box + " --set particles.file=\"$PWD\"/sizes.csv");
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  INFO(outcome.err);
  CHECK(outcome.code == 0);
  CHECK(passed.count() < 30);  // 2 s on a quiet machine
}

TEST_CASE("Pipes and devices in place of input files are refused, but a case may come from a pipe") {
  const Workplace place;
  for (const char* name : {"pipe.csv", "pipe.stl", "pipe.yaml"})
    REQUIRE(::mkfifo((place.path() / name).c_str(), 0600) == 0);
  const std::string here = "=\"$PWD\"/";
  check_refused(place, "check " + quickstart + " --set crusher.profile" + here + "pipe.csv", "is a pipe or a device");
  check_refused(place, "check " + box + " --set particles.file=/dev/zero", "is a pipe or a device");
  check_refused(place, "check " + quickstart + " --set rocks.shapes=\"{files: [$PWD/pipe.stl]}\"",
                "is a pipe or a device");
  check_refused(place, "check " + box + wall("") + " --set walls.extra.stl" + here + "pipe.stl",
                "is a pipe or a device");
  check_refused(place, "check pipe.yaml", "is a pipe into which nobody has written for 10 s");
  const Outcome read =
      place.shell("sed 's#box-part#" GYRO_CASES "/box-part#; s/0.5 s/0.5 kg/' " + box + " | $GYROSIM check /dev/stdin");
  CHECK(read.code == 2);
  CHECK_THAT(read.err, Contains("/dev/stdin:4:18: time.duration: \"0.5 kg\" is a mass"));
}

TEST_CASE("A run whose numbers cease to be finite leaves no such number in its tables") {
  const Workplace place;
  const std::string gravity = GENERATE(" --set gravity='[0, 0, -1e200]'", " --set gravity='[0, 0, -1e30]'");
  const Outcome outcome = place.gyrosim("run " + box + gravity + " --set output.series='0.5 ms' --out r");
  INFO(outcome.err);
  CHECK(outcome.code == 4);
  for (const auto& [name, numbers] : all_results(place.path() / "r"))
    for (const double number : numbers) {
      INFO(name);
      CHECK(std::isfinite(number));
    }
  CHECK_THAT(outcome.out, !Contains("nan"));
  CHECK(place.gyrosim("report r").code == 0);
}
