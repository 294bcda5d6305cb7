// SPDX-License-Identifier: GPL-3.0-or-later
// Complete runs of small cases through the program: their outputs, which are the same in every run.
#include "io/hdf5/hdf5.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace {

using namespace gyro;
using nlohmann::json;
namespace fs = std::filesystem;

const std::string crush = "'" GYRO_APP_CASES "/crush.yaml'", platen = "'" GYRO_APP_CASES "/platen.yaml'",
                  box = "'" GYRO_CASES "/box.yaml'", quickstart = "'" GYRO_CASES "/quickstart.yaml'";

/// Runs a case to its end. @returns the run's directory
fs::path done(const Workplace& place, const std::string& arguments, const std::string& name) {
  const Outcome outcome = place.gyrosim("run " + arguments + " --out " + name);
  INFO(arguments << "\n" << outcome.err);
  REQUIRE(outcome.code == 0);
  return place.path() / name;
}

/// The fragments of a run add up to its masses, and those that left are those of the product.
void require_fragments(const fs::path& run) {
  const json summary = summary_of(run);
  const auto of = [&](const std::string& column) { return result_of(run, "fragments/" + column); };
  const std::vector<double> place = of("place"), mass = of("mass"), time = of("time"), size = of("size"),
                            particles = of("particles"), fed = of("fed"), sieves = result_of(run, "product/sizes");
  double inside = 0, discharged = 0, singles = 0, remaining = 0;
  std::vector<double> fine(sieves.size());
  for (std::size_t k = 0; k < place.size(); ++k) {
    CHECK((fed[k] >= 0 && fed[k] <= time[k]));
    if (place[k] == 0) {
      CHECK(time[k] == Approx(summary["simulated_seconds"].get<double>()));
      inside += mass[k];
      ++remaining;
      continue;
    }
    discharged += mass[k];
    if (particles[k] == 1) singles += mass[k];
    for (std::size_t s = 0; s < sieves.size(); ++s)
      if (size[k] <= sieves[s]) fine[s] += mass[k];
  }
  CHECK(std::is_sorted(time.begin(), time.end()));
  REQUIRE(discharged > 0);
  CHECK(discharged == Approx(summary["discharged_mass"].get<double>()));
  CHECK(inside == Approx(summary["holdup_mass"].get<double>()));
  CHECK(singles / discharged == Approx(summary["singles_share"].get<double>()));
  CHECK(remaining == result_of(run, "holdup/fragments").back());
  const bool is_fed = result_of(run, "series/feed_mass").back() > result_of(run, "series/feed_mass").front();
  CHECK((*std::max_element(fed.begin(), fed.end()) > 0) == is_fed);
  const std::vector<double> passing = result_of(run, "product/passing");
  for (std::size_t s = 0; s < sieves.size(); ++s)
    CHECK(fine[s] / discharged == Approx(passing[passing.size() - sieves.size() + s]).margin(1e-12));
}

}  // namespace

TEST_CASE("One and two threads give the same numbers, and another seed gives others") {
  const Workplace place;
  const std::string run = crush + " --until '15 ms'";
  const auto one = all_results(done(place, run + " --threads 1", "one")),
             two = all_results(done(place, run + " --threads 2", "two")),
             other = all_results(done(place, run + " --set case.seed=2", "other"));
  REQUIRE(one.size() > 35);
  REQUIRE(one.size() == two.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    INFO(one[k].first);
    CHECK(one[k].first == two[k].first);
    CHECK(one[k].second == two[k].second);
  }
  CHECK(summary_of(place.path() / "one")["bonds_broken"] > 5);
  CHECK(result_of(place.path() / "one", "series/crushing_power") !=
        result_of(place.path() / "other", "series/crushing_power"));
}

TEST_CASE("A crusher's run has every series, and its summary agrees with them") {
  const Workplace place;
  const fs::path run = done(place, crush + " --until '60 ms'", "r");
  for (const char* name :
       {"time",         "motor_speed",          "eccentric_speed",    "eccentric_angle", "mantle_spin",
        "motor_torque", "mantle_torque",        "motor_power",        "crushing_power",  "mantle_force",
        "feed_mass",    "discharged_mass",      "holdup_mass",        "throughput",      "particles",
        "bonds_intact", "bonds_broken_tension", "bonds_broken_shear", "fragments",       "max_overlap_ratio",
        "loss_power",   "wall_seconds",         "escaped_mass"}) {
    INFO(name);
    const std::size_t columns = std::string(name) == "mantle_force" ? 3 : 1;
    CHECK(result_of(run, std::string("series/") + name).size() == 120 * columns);
    CHECK(
        !hdf5::File::open(run / "results.h5").dataset(std::string("series/") + name).string_attribute("units").empty());
  }
  for (const char* name :
       {"kinetic", "potential", "contact_elastic", "bond_elastic", "contact_damping", "friction", "bond_damping",
        "bond_breakage", "wall_work", "energy_residual", "momentum_residual", "mass_residual", "power_residual"})
    CHECK(result_of(run, std::string("ledger/") + name).size() == 120);

  const json summary = summary_of(run);
  CHECK(summary["status"] == "done");
  CHECK(summary["mass_residual_fraction"] == 0);
  CHECK(summary["momentum_residual_fraction"].get<double>() < 1e-9);
  CHECK(std::abs(summary["energy_residual_fraction"].get<double>()) < 0.01);
  CHECK(summary["stalled"] == false);
  CHECK(summary["precision"] == "mixed");
  const double tension = result_of(run, "series/bonds_broken_tension").back(),
               shear = result_of(run, "series/bonds_broken_shear").back(),
               intact = result_of(run, "series/bonds_intact").back();
  const double broken = summary["bonds_broken"];
  CHECK(broken > 50);
  CHECK(tension + shear == broken);
  CHECK(intact + broken == summary["bonds_initial"].get<double>());
  CHECK(static_cast<double>(result_of(run, "breakage/time").size()) == broken);
  CHECK(result_of(run, "ledger/mass_residual") == std::vector<double>(120, 0.0));
  const double fed = summary["feed_mass"], discharged = summary["discharged_mass"];
  CHECK(result_of(run, "series/holdup_mass").back() == Approx(fed - discharged));
  CHECK(summary["throughput_tph"].get<double>() == Approx(discharged / 0.06 * 3.6));
  CHECK((summary["escaped_mass"] == 0 && summary["escaped_fraction"] == 0));
  CHECK(result_of(run, "product/mass").back() == discharged);
  CHECK(result_of(run, "holdup/mass").back() == Approx(fed - discharged));
  CHECK(result_of(run, "holdup/fragments").back() + result_of(run, "product/fragments").back() ==
        result_of(run, "series/fragments").back());
  require_fragments(run);
  CHECK(result_of(run, "holdup/p80").front() > result_of(run, "holdup/p80").back());
  for (const std::string curve : {"product", "holdup"})
    CHECK(result_of(run, curve + "/below_oss").back() >= result_of(run, curve + "/below_css").back());
  for (const char* name : {"p80", "p50", "singles_share"})
    CHECK(summary[name].get<double>() == result_of(run, std::string("product/") + name).back());
  CHECK(summary["product_below_css"] == result_of(run, "product/below_css").back());
  CHECK(summary["product_below_oss"] == result_of(run, "product/below_oss").back());
  CHECK(summary["swell_of_crumbled"] > 1);
  const std::vector<double> power = result_of(run, "series/crushing_power");
  CHECK(summary["mean_crushing_power"].get<double>() ==
        Approx(std::accumulate(power.begin(), power.end(), 0.0) / 120).epsilon(1e-9));
  CHECK(result_of(run, "ledger/wall_work").back() ==
        Approx(0.06 * summary["mean_crushing_power"].get<double>()).epsilon(1e-3));
  for (const char* name : {"particles_000000.vtp", "bonds_000006.vtp"}) CHECK(fs::exists(run / "snapshots" / name));
}

TEST_CASE("A scene without bonds, feed, crusher and drive has no output of them") {
  const Workplace place;
  const fs::path run = done(place, box + " --until '60 ms'", "r");
  CHECK(results_in(run, "series") == std::vector<std::string>{"max_overlap_ratio", "particles", "time",
                                                              "wall_force_back", "wall_force_floor", "wall_force_front",
                                                              "wall_force_left", "wall_force_right", "wall_seconds"});
  for (const std::string group : {"breakage", "product", "holdup", "liners"}) CHECK(results_in(run, group).empty());
  CHECK(result_of(run, "fragments/time") == std::vector<double>(300, result_of(run, "series/time").back()));
  CHECK(result_of(run, "fragments/place") == std::vector<double>(300, 0.0));
  CHECK(result_of(run, "fragments/position").size() == 900);
  const json summary = summary_of(run);
  CHECK(summary["particles"] == 300);
  CHECK(summary["bonds_initial"] == 0);
  CHECK(summary["bond_steps"] == 0);
  for (const char* name : {"feed_mass", "discharged_mass", "escaped_mass", "throughput_tph",
                           "specific_energy_kwh_per_t", "p80", "p50", "singles_share", "mean_crushing_power"})
    CHECK(summary[name].is_null());
  CHECK(summary["mass_residual_fraction"] == 0);
  CHECK(!fs::exists(run / "bonds.pvd"));
  CHECK(read_text(run / "log.txt").find("advance rocks") != std::string::npos);  // phases are listed
  CHECK(read_text(run / "log.txt").find("sum bonds") == std::string::npos);
}

TEST_CASE("The energy residual of impacts falls with the step") {
  const Workplace place;
  double coarser = 0.02 / 0.6;
  for (const std::string safety : {"0.7", "0.35", "0.175"}) {
    const fs::path run = done(place, box + " --until '60 ms' --set time.safety=" + safety, safety);
    const double residual = std::abs(summary_of(run)["energy_residual_fraction"].get<double>());
    INFO(safety << ": " << residual);
    CHECK(residual < 0.6 * coarser);
    coarser = residual;
  }
}

TEST_CASE("A rock between plates breaks, and its energies close within half a percent") {
  const Workplace place;
  const fs::path run = done(place, platen, "r");
  const json summary = summary_of(run);
  CHECK(summary["bonds_broken"] > 20);
  CHECK(std::abs(summary["energy_residual_fraction"].get<double>()) < 0.005);
  CHECK(result_of(run, "ledger/wall_work").back() > 0);
  CHECK(result_of(run, "ledger/bond_breakage").back() > 0);
  const std::vector<double> fragments = result_of(run, "series/fragments");
  CHECK(fragments.front() == 1);
  CHECK(fragments.back() > 3);
  for (const std::string& name : results_in(run, "series")) CHECK(name.find("motor") == std::string::npos);
}

TEST_CASE("A Brazilian disc splits: curve, forces and strength are in the summary") {
  const Workplace place;
  const std::string coarse = " --set rocks.fill.ratio=6 --set bonds.strength_scatter=null --set output.snapshots=0";
  const fs::path run = done(place, "'" GYRO_CASES "/laboratory/brazilian.yaml'" + coarse, "r");
  const json test = summary_of(run)["laboratory"];
  INFO(test.dump(1));
  REQUIRE(test["failure_force"].is_number());
  CHECK(test["test"] == "brazilian");
  CHECK(test["broken_before"] == 0);
  CHECK(test["first_break_force"] > 0);
  CHECK(test["first_break_force"] <= test["failure_force"]);
  CHECK(test["strength"] ==
        Approx(2 * test["failure_force"].get<double>() / (3.14159265 * 0.05 * 0.025)).epsilon(0.01));
  CHECK(test["middle_breaks"].is_number());
  std::istringstream curve(read_text(run / "force_displacement.csv"));
  std::string line;
  std::getline(curve, line);
  CHECK(line == "displacement_m,force_N");
  double largest = 0;
  while (std::getline(curve, line)) largest = std::max(largest, std::stod(line.substr(line.find(',') + 1)));
  CHECK(largest >= 0.999 * test["failure_force"].get<double>());
  CHECK(read_text(run / "log.txt").find("-0 N") == std::string::npos);
}

TEST_CASE("The quickstart starts well: energies within 2 %, no particle lost, nothing stopped") {
  const Workplace place;
  const fs::path run = done(place, quickstart + " --until '15 ms'", "r");
  const json summary = summary_of(run);
  CHECK(summary["particles"] > 1000);
  CHECK(summary["mass_residual_fraction"] == 0);
  CHECK(std::abs(summary["energy_residual_fraction"].get<double>()) < 0.02);
  CHECK(result_of(run, "series/time").size() == 15);
}

TEST_CASE("A run whose directory another run has taken writes nothing more there") {
  const Workplace place;
  // Another machine, whose locks are not visible here, names itself as the holder. The run looks every 10 s.
  const Outcome outcome =
      place.shell("\"$GYROSIM\" run " + box +
                  " --set 'time.duration=10 h' --set 'output.snapshots=5 ms' --out r --max-walltime '60 s' & run=$!; "
                  "until test -e r/snapshots/particles_000002.vtp || ! kill -0 $run 2>/dev/null; do sleep 0.02; done; "
                  "printf 'host other\npid 1\nsince now\nbeat 1\n' > r/run.lock; wait $run");
  INFO(outcome.err);
  CHECK(outcome.code == 5);
  CHECK_THAT(outcome.err, Catch::Matchers::Contains("r: another run has taken this directory"));
  CHECK(read_text(place.path() / "r/run.lock").starts_with("host other"));
  CHECK_FALSE(fs::exists(place.path() / "r/summary.json"));
  CHECK_FALSE(fs::exists(place.path() / "r/checkpoint.h5"));
}
