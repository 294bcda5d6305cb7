// SPDX-License-Identifier: GPL-3.0-or-later
// crusher.lid: rock that is thrown over the rim escapes without it, and stays in the chamber with it.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <sstream>

using namespace gyro;
using Catch::Matchers::Contains;

namespace {

/// The quickstart's crusher, whose rim has a radius of 0.2406 m at z = 0.4 m, with spheres from a file.
const std::string spheres = "'" GYRO_CASES
                            "/quickstart.yaml' --set feed=null --set rocks=null --set bonds=null "
                            "--set 'particles={file: '$PWD'/spheres.csv}' --set 'time.duration=0.6 s' "
                            "--set output.snapshots=0 --set 'output.series=10 ms' ";

/// A ring of spheres near the rim that fly outwards and upwards, as fragments do that mantle and concave throw out.
void write_spheres(const Workplace& place, double top) {
  std::ostringstream text;
  text << "id,x,y,z,r,vx,vy,vz\n";
  for (int k = 0; k < 12; ++k) {
    const double angle = 0.5236 * k, x = std::cos(angle), y = std::sin(angle);
    text << k << "," << 0.2 * x << "," << 0.2 * y << "," << (k == 0 ? top : 0.38) << ",0.01," << 0.8 * x << ","
         << 0.8 * y << "," << 1.5 << "\n";
  }
  place.write("spheres.csv", text.str());
}

}  // namespace

TEST_CASE("Rock that is thrown over the rim escapes, and with a lid it stays in the chamber") {
  const Workplace place;
  write_spheres(place, 0.38);
  REQUIRE(place.shell("$GYROSIM run " + spheres + " --quiet --out open").code == 0);
  const Outcome closed = place.shell("$GYROSIM run " + spheres + " --set 'crusher.lid=450 mm' --quiet --out closed");
  INFO(closed.err);
  REQUIRE(closed.code == 0);
  const nlohmann::json without = summary_of(place.path() / "open"), with = summary_of(place.path() / "closed");
  CHECK(without["escaped_mass"] > 0.1);
  CHECK(with["escaped_mass"] == 0);
  CHECK(with["mass_residual_fraction"] == 0);
  CHECK(std::abs(with["energy_residual_fraction"].get<double>()) < 1e-3);
  const std::vector<double> force = result_of(place.path() / "closed", "series/wall_force_lid");
  double up = 0;  // of the rock on the plate
  for (std::size_t k = 2; k < force.size(); k += 3) up = std::max(up, force[k]);
  CHECK(up > 0);
}

TEST_CASE("Rock above a lid, and a lid without room or rim, are refused with the place in the case") {
  const Workplace place;
  write_spheres(place, 0.445);
  const auto refused = [&](const std::string& options, const std::string& message) {
    const Outcome outcome = place.shell("$GYROSIM check " + options);
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Contains(message));
  };
  const std::string quickstart = "'" GYRO_CASES "/quickstart.yaml' ";
  refused(spheres + "--set 'crusher.lid=450 mm'", "a particle reaches to z = 455 mm, above the lid at 450 mm");
  refused(quickstart + "--set 'crusher.lid=399 mm'",
          "--set:1:1: the lid at z = 399 mm is not above the rim of the concave at 400 mm");
  refused(quickstart + "--set 'crusher.lid=420 mm' --set 'feed.rate=1 kg/s'",
          "quickstart.yaml:38:1: the feed (twice the largest rock above the wall) reaches to z = ");
  refused(quickstart + "--set 'crusher.lid=420 mm' --set 'feed.initial_top=430 mm'",
          "the initial charge reaches to z = 430 mm");
  refused(quickstart + "--set 'crusher.lid=420 mm' --set 'feed={rocks: 1, at: [0.15, 0, 0.45]}'",
          "above the lid at 420 mm");
  refused(quickstart +
              "--set 'crusher.lid=450 mm' --set "
              "'walls.lid={plane: {point: [0, 0, 1], normal: [0, 0, -1]}, material: steel}'",
          "crusher.lid makes a wall called lid");
  CHECK(place.shell("$GYROSIM check " + quickstart + "--set 'crusher.lid=700 mm' --set 'feed.rate=1 kg/s'").code == 0);
}

TEST_CASE("A lid closes a concave of triangles, unless its rim is so far from round that particles pass") {
  const Workplace place;
  write_spheres(place, 0.38);
  REQUIRE(place.gyrosim("liners '" GYRO_CASES "/quickstart.yaml' --out liners").code == 0);
  const std::string meshes = spheres +
                             "--set crusher.profile=null --set 'walls={concave: {stl: '$PWD'/liners/concave.stl, "
                             "material: steel}, mantle: {stl: '$PWD'/liners/mantle.stl, material: steel, "
                             "motion: gyration}}' --set 'crusher.lid=450 mm' ";
  const Outcome run = place.shell("$GYROSIM run " + meshes + " --until '0.4 s' --quiet --out r");
  INFO(run.err);
  REQUIRE(run.code == 0);
  CHECK(summary_of(place.path() / "r")["escaped_mass"] == 0);
}

TEST_CASE("Notes on walls are about those of the case, not about the lid") {
  const Workplace place;
  const bool meshes = GENERATE(false, true);
  std::string options = spheres + "--set 'crusher.lid=450 mm' --set 'time.duration=10 ms' ";
  if (meshes) {
    REQUIRE(place.gyrosim("liners '" GYRO_CASES "/quickstart.yaml' --out liners").code == 0);
    options +=
        "--set crusher.profile=null --set 'walls={concave: {stl: '$PWD'/liners/concave.stl, material: steel}, "
        "mantle: {stl: '$PWD'/liners/mantle.stl, material: steel, motion: gyration}}' ";
  }
  const auto notes = [&](const std::string& sphere) {
    place.write("spheres.csv", "id,x,y,z,r\n" + sphere + "\n");
    const Outcome outcome = place.shell("$GYROSIM check " + options + "--json");
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return nlohmann::json::parse(outcome.out)["notes"].dump();
  };
  const std::string far = notes("1,0,0,-100,0.3");
  CHECK_THAT(far, Contains("wall concave: ") && Contains("so that nothing touches it") &&
                      Contains("smaller than the smallest particle") && !Contains("wall lid"));
  CHECK_THAT(notes("1,0,0,-100,1e-5"),
             Contains("wall mantle: ") && Contains("times the largest rock") && !Contains("wall lid"));
}
