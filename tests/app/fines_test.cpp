// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate of what is finer than particles, in runs of a crusher.
#include "tests/app/program.hpp"
#include "tests/app/small_crusher.hpp"
#include "tests/catch.hpp"

#include "io/hdf5/hdf5.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace {

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

const std::string crush = "run '" GYRO_APP_CASES
                          "/crush.yaml' --set feed.rate=20 --set 'crusher.removal_depth=1 mm' "
                          "--set 'output.series=2 ms' --set output.snapshots=0 ";
const std::string breakage = "--set 'output.fines={breakage: {A: 64.5 %, b: 10.5 t/kWh}}' ";

std::map<std::string, std::vector<double>> results_of(const fs::path& run) {
  std::map<std::string, std::vector<double>> all;
  for (auto& [name, numbers] : all_results(run)) all[name] = numbers;
  return all;
}

double attribute_of(const fs::path& run, const std::string& group, const std::string& name) {
  return hdf5::File::open(run / "results.h5").number_attribute(group, name);
}

/// Share of the mass in each row of a curve that is not in its sieves, which reach from 1 mm to 1 m.
double missing(const std::vector<double>& passing) {
  return std::abs(1 - passing.back());
}

}  // namespace

TEST_CASE("Fines are additional curves and figures: all others keep their bits, and no mass is lost") {
  const Workplace place;
  const Outcome plain = place.gyrosim(crush + "--until '130 ms' --out plain");
  REQUIRE(plain.code == 0);
  const std::string law =
      GENERATE(as<std::string>{}, breakage, "--set 'output.fines={gates_gaudin_schuhmann: {m: 0.8}}' ");
  const bool by_energy = law == breakage;
  const Outcome outcome = place.gyrosim(crush + law + "--until '130 ms' --out fines");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const auto without = results_of(place.path() / "plain");
  auto with = results_of(place.path() / "fines");
  for (const auto& [name, numbers] : without) {
    INFO(name);
    REQUIRE(with.contains(name));
    CHECK(with[name] == numbers);
    with.erase(name);
  }
  CHECK(with.size() == (by_energy ? 14 : 10));
  for (const std::string table : {"product", "holdup"}) {
    const std::vector<double> passing = without.at(table + "/passing"), fines = with.at(table + "/passing_with_fines");
    REQUIRE(passing.size() == fines.size());
    bool finer = true;
    for (std::size_t k = 0; k < passing.size(); ++k) finer = finer && fines[k] >= passing[k] - 1e-14;
    CHECK(finer);
    CHECK(missing(fines) < 1e-14);
    CHECK(with.at(table + "/fines_share").back() > 0);
  }
  const nlohmann::json summary = summary_of(place.path() / "fines"), before = summary_of(place.path() / "plain");
  CHECK(before["fines"].is_null());
  CHECK(summary["p80"] == before["p80"]);
  CHECK(summary["resolution"] == before["resolution"]);
  CHECK(summary["resolution"] == attribute_of(place.path() / "plain", "/product", "resolution"));
  CHECK(summary["finest_particle"] == attribute_of(place.path() / "plain", "/holdup", "finest_particle"));
  CHECK(summary["fines"]["p80"] == with.at("product/p80_with_fines").back());
  CHECK(summary["fines"]["p50"] <= before["p50"]);
  CHECK(summary["fines"]["t10"].is_null() != by_energy);
  CHECK_THAT(plain.out, Contains("  resolution        particles of ") && Contains("; finer product is unknown\n"));
  CHECK_THAT(outcome.out, Contains("mm estimated, by ") && Contains("  with fines        P80 ") &&
                              Contains(by_energy ? "; bonds released " : "Gates-Gaudin-Schuhmann"));
  CHECK(place.gyrosim("report fines").out == outcome.out);
  CHECK_THAT(place.gyrosim("export csv fines --table product").out, Contains(",passing_with_fines_0.9766mm,"));
}

TEST_CASE("A run in parts has the fines of an uninterrupted one") {
  const Workplace place;
  const std::string run = crush + breakage;
  REQUIRE(place.gyrosim(run + "--until '130 ms' --out whole").code == 0);
  REQUIRE(place.gyrosim(run + "--until '17 ms' --out parts").code == 0);  // in the middle of a row
  REQUIRE(place.gyrosim(run + "--until '119 ms' --out parts --resume --threads 2").code == 0);
  const Outcome changed = place.gyrosim(crush + "--until '130 ms' --out parts --resume");
  CHECK(changed.code == 2);
  CHECK_THAT(changed.err, Contains("output.fines.breakage.A is absent"));
  REQUIRE(place.gyrosim(run + "--until '130 ms' --out parts --resume").code == 0);
  const auto whole = results_of(place.path() / "whole"), parts = results_of(place.path() / "parts");
  std::size_t compared = 0;
  for (const auto& [name, numbers] : whole) {
    INFO(name);
    CHECK(parts.at(name) == numbers);
    ++compared;
  }
  CHECK(compared > 50);
  CHECK(whole.at("product/released_energy").back() > 0);
  CHECK(summary_of(place.path() / "whole")["fines"] == summary_of(place.path() / "parts")["fines"]);
}

TEST_CASE("The energy of all particles is what the ledger calls breakage") {
  SmallCrusher crusher({"output.fines={breakage: {A: 64.5 %, b: 10.5 t/kWh}}", "feed.rate=20"});
  Simulation& simulation = crusher.simulation;
  double released = 0;
  while (simulation.time() < 0.06)
    for (const Breakage& broken : simulation.advance().breakages) released += broken.energy;
  const RockHistory::State history = simulation.fines()->state().history;
  REQUIRE(simulation.dem().counts().particles == static_cast<std::int64_t>(history.particle.size()));
  const double total = std::accumulate(history.energy.begin(), history.energy.end(), 0.0);
  CHECK(total > 0);
  CHECK(total == Approx(released).epsilon(1e-12));
  CHECK(total == Approx(simulation.ledger().energy().bond_breakage).epsilon(1e-12));
  // Each rock has the size of its template.
  for (const double size : history.size) {
    bool known = false;
    for (const RockTemplate& rock : crusher.assembly.setup.library.rocks)
      known = known || std::abs(size / rock.diameter - 1) < 1e-9;
    CHECK(known);
  }
}

TEST_CASE("The resolution is that of the rock that can break, from its finest to its coarsest particle") {
  const SmallCrusher graded({"rocks.fill={sizes: [7 mm, 9 mm]}"});
  REQUIRE(graded.assembly.resolution);
  double lightest = 1, heaviest = 0;
  for (const double mass : graded.dem.particles().mass) {
    lightest = std::min(lightest, mass);
    heaviest = std::max(heaviest, mass);
  }
  const auto size = [](double mass) { return std::cbrt(6 * mass / (std::numbers::pi * 2600)); };
  CHECK(graded.assembly.resolution->finest <= size(lightest) * (1 + 1e-12));
  CHECK(graded.assembly.resolution->coarsest >= size(heaviest) * (1 - 1e-12));
  CHECK(graded.assembly.resolution->coarsest > 1.2 * graded.assembly.resolution->finest);
  CHECK_FALSE(SmallCrusher({"bonds=null"}).assembly.resolution);
}
