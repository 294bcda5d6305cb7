// SPDX-License-Identifier: GPL-3.0-or-later
// feed.initial_from: a chamber that begins with the hold-up of another run.
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>

using namespace gyro;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

const std::string crush = "'" GYRO_APP_CASES "/crush.yaml' --set output.snapshots=0 ";
/// A filled chamber in which rock breaks and leaves.
const std::string coarse =
    "run " + crush + "--set 'feed.initial=2 kg' --set 'feed.initial_top=300 mm' --set feed.rate=10 --quiet ";
/// The same machine with other rocks of smaller particles, and a wider setting.
const std::string other =
    crush +
    "--set feed.initial=null --set feed.initial_top=null --set feed.rate=10 --set case.seed=4 "
    "--set 'rocks.fill={ratio: 5}' --set rocks.samples=5 --set 'crusher.closed_side_setting=16 mm' ";
const std::string from = "--set feed.initial_from=$PWD/coarse ";

/// The fragments of a run's /fragments that were in the chamber at its end.
struct HoldUp {
  std::vector<double> height, mass, particles;
  explicit HoldUp(const fs::path& run) {
    const std::vector<double> place = result_of(run, "fragments/place"), m = result_of(run, "fragments/mass"),
                              p = result_of(run, "fragments/position"), n = result_of(run, "fragments/particles");
    for (std::size_t k = 0; k < place.size(); ++k) {
      if (place[k] != 0) continue;
      height.push_back(p[3 * k + 2]);
      mass.push_back(m[k]);
      particles.push_back(n[k]);
    }
  }
  double sum() const {
    double all = 0;
    for (const double m : mass) all += m;
    return all;
  }
  double below(double z) const {
    double found = 0;
    for (std::size_t k = 0; k < mass.size(); ++k) found += height[k] < z ? mass[k] : 0;
    return found;
  }
  double singles() const {
    double found = 0;
    for (std::size_t k = 0; k < mass.size(); ++k) found += particles[k] == 1 ? mass[k] : 0;
    return found;
  }
};

}  // namespace

TEST_CASE("A chamber is filled by height and size as another run left it, with other rocks") {
  const Workplace place;
  REQUIRE(place.gyrosim(coarse + "--out coarse --until '0.2 s'").code == 0);
  const HoldUp source(place.path() / "coarse");
  REQUIRE(source.mass.size() > 50);
  REQUIRE(source.singles() > 0.05 * source.sum());
  const Outcome run = place.shell("$GYROSIM run " + other + from + "--quiet --until '0.5 ms' --out fine");
  INFO(run.err);
  REQUIRE(run.code == 0);
  const HoldUp made(place.path() / "fine");
  const nlohmann::json summary = summary_of(place.path() / "fine");
  CHECK(summary["start_mass"].get<double>() + summary["start_missing"].get<double>() ==
        Approx(source.sum()).epsilon(0.01));
  CHECK(summary["start_missing"] < 0.01 * source.sum());
  CHECK(summary["feed_mass"].get<double>() == Approx(0).margin(0.05));  // what fills the chamber is not fed
  CHECK(made.singles() == Approx(source.singles()).epsilon(0.1));
  // Mass below each height within 5 % of all.
  for (double z = 0.02; z < 0.4; z += 0.02) {
    INFO(z);
    CHECK(std::abs(made.below(z) - source.below(z)) < 0.05 * source.sum());
  }
  CHECK_THAT(read_text(place.path() / "fine/log.txt"),
             Contains("feed.initial_from: the hold-up of ") && Contains("digest ") && Contains(" kg placed"));
  CHECK_THAT(read_text(place.path() / "fine/case.yaml"),
             Contains("initial_from: ") && Contains("/coarse/checkpoint.h5"));

  const Outcome check = place.shell("$GYROSIM check " + other + from);
  INFO(check.err);
  CHECK(check.code == 0);
  CHECK_THAT(check.out, Contains("feed.initial_from: the hold-up of ") && Contains("this run begins with ") &&
                            Contains("filling        ") && Contains(" kg placed, 0 kg without room"));
}

TEST_CASE("A filled run has the same bits on two threads and in parts, and refuses a changed source") {
  const Workplace place;
  REQUIRE(place.gyrosim(coarse + "--out coarse --until '0.2 s'").code == 0);
  const std::string run = "$GYROSIM run " + other + from + "--quiet ";
  REQUIRE(place.shell(run + "--out whole").code == 0);
  REQUIRE(place.shell(run + "--out parts --until '31 ms' --threads 2").code == 0);
  REQUIRE(place.shell(run + "--out parts --resume").code == 0);
  const auto whole = all_results(place.path() / "whole"), parts = all_results(place.path() / "parts");
  REQUIRE(whole.size() == parts.size());
  for (std::size_t k = 0; k < whole.size(); ++k) {
    INFO(whole[k].first);
    CHECK(whole[k] == parts[k]);
  }
  CHECK(summary_of(place.path() / "parts")["start_mass"] == summary_of(place.path() / "whole")["start_mass"]);
  CHECK(std::abs(summary_of(place.path() / "whole")["energy_residual_fraction"].get<double>()) < 0.01);
  CHECK(summary_of(place.path() / "whole")["mass_residual_fraction"] == 0);

  REQUIRE(place.shell(run + "--out again --until '5 ms'").code == 0);
  REQUIRE(place.gyrosim(coarse + "--out coarse --resume --until '0.21 s'").code == 0);
  const Outcome changed = place.shell(run + "--out again --resume");
  CHECK(changed.code == 2);
  CHECK_THAT(changed.err, Contains("coarse/checkpoint.h5: has changed since"));
}

TEST_CASE("Sources that cannot be used are refused with the place in the case") {
  const Workplace place;
  REQUIRE(place.gyrosim("run '" GYRO_CASES "/box.yaml' --quiet --until '1 ms' --out box").code == 0);
  REQUIRE(place.gyrosim("run " + crush + "--quiet --until '1 ms' --out crushed").code == 0);
  fs::create_directory(place.path() / "empty");
  place.write("text.h5", "nothing of the kind\n");
  const auto refused = [&](const std::string& options, const std::string& message) {
    const Outcome outcome = place.shell("$GYROSIM run " + other + options + " --out new");
    INFO(outcome.err);
    CHECK(outcome.code == 2);
    CHECK_THAT(outcome.err, Contains("--set:") && Contains(message));
  };
  refused("--set feed.initial_from=$PWD/empty", "is a directory without checkpoint.h5; give the directory of a run");
  refused("--set feed.initial_from=$PWD/nowhere", "does not exist");
  refused("--set feed.initial_from=$PWD/text.h5", "is damaged, not a checkpoint, or one of an older version");
  refused("--set feed.initial_from=$PWD/box", "is of a run without a crusher");
  refused("--set feed.initial_from=$PWD/crushed --set 'materials.rock.density=2700 kg/m3'",
          "is of a run with other rock: materials.rock.density is ");
  refused("--set feed.initial_from=$PWD/crushed --set feed.initial=1", "feed.initial cannot be combined with");
  refused("--set feed.initial_from=$PWD/crushed --set feed.rate=null --set feed.mass=1",
          "cannot be combined with feed.mass");
  const Outcome own =
      place.shell("$GYROSIM run " + other + "--set feed.initial_from=$PWD/crushed --out crushed --overwrite");
  CHECK(own.code == 2);
  CHECK_THAT(own.err, Contains("is the directory of this run"));
  CHECK_FALSE(fs::exists(place.path() / "new"));
  CHECK(fs::exists(place.path() / "crushed/checkpoint.h5"));
}
