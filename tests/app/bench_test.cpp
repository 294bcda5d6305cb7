// SPDX-License-Identifier: GPL-3.0-or-later
// `gyrosim bench accuracy`: its statistics against hand calculations, its shape against what is documented.
#include "app/bench/accuracy.hpp"
#include "app/bench/first_break.hpp"
#include "app/bench/size.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <set>

using namespace gyro;
using namespace gyro::bench;
namespace fs = std::filesystem;

namespace {

const double nothing = std::numeric_limits<double>::quiet_NaN();

fs::path scene_folder() {
  return fs::path(GYRO_CASES) / "bench" / "accuracy";
}

/// Copies R1, cut to 2 ms, into a folder and gives it a reference of two seeds.
AccuracyScene short_platen(const fs::path& folder) {
  for (const char* file : {"platen.yaml", "platen-particles.csv", "platen-bonds.csv"})
    fs::copy(scene_folder() / file, folder / file);
  std::string text = read_text(folder / "platen.yaml");
  const std::string duration = "duration: 30 ms";
  REQUIRE(text.find(duration) != std::string::npos);
  std::ofstream(folder / "platen.yaml") << text.replace(text.find(duration), duration.size(), "duration: 2 ms");
  AccuracyScene scene = accuracy_scenes().front();
  scene.seeds = 2;
  write_reference(folder / "reference.json", scene.name, make_reference(scene, folder, 1));
  return scene;
}

}  // namespace

TEST_CASE("Mean and standard error of a sample, members without a value left out") {
  const std::vector<double> sample{1, 2, nothing, 3, 6};  // mean 3, squares 4 + 1 + 0 + 9 = 14
  const Mean mean = mean_of(sample);
  CHECK(mean.count == 4);
  CHECK(mean.value == Approx(3));
  CHECK(mean.error == Approx(std::sqrt(14.0 / 3 / 4)));
  CHECK(std::isnan(mean_of(std::vector<double>{5}).error));
  CHECK(std::isnan(mean_of(std::vector<double>{nothing}).value));
}

TEST_CASE("An ensemble's error is the mean of paired differences over the reference's mean") {
  const std::vector<double> measured{11, 22, 30}, reference{10, 20, 30}, coarse{10, 20, 31};
  // Differences 1, 2, 0: mean 1, standard error sqrt(2/2/3); reference: mean 20, standard error sqrt(200/2/3).
  const Deviation d = deviation(Family::ensemble, {measured, reference, coarse});
  CHECK(d.error == Approx(1.0 / 20));
  CHECK(d.bias == Approx(1.0 / 20));
  CHECK(d.error_se == Approx(std::sqrt(1.0 / 3) / 20));
  CHECK(d.noise == Approx(std::sqrt(100.0 / 3) / 20));
  CHECK(d.mean == Approx(21));
  CHECK(d.seeds == 3);
  const Deviation down = deviation(Family::ensemble, {reference, measured, coarse});
  CHECK(down.bias == Approx(-1.0 / 21));
  CHECK(down.error == Approx(1.0 / 21));
}

TEST_CASE("Errors of a path do not cancel, identities agree or not, and an invariant is compared with zero") {
  const std::vector<double> measured{11, 18, nothing}, reference{10, 20, 30}, coarse{10.1, 20, 30};
  const Deviation path = deviation(Family::path, {measured, reference, coarse});
  CHECK(path.error == Approx(0.1));  // +10 %, -10 %
  CHECK(path.bias == Approx(0).margin(1e-15));
  CHECK(path.noise == Approx(0.01 / 3));
  CHECK(path.seeds == 2);
  const std::vector<double> bonds{7, 8, 9, 9}, bonds_reference{7, 8, 9, 1};
  const Deviation names = deviation(Family::identity, {bonds, bonds_reference, bonds_reference});
  CHECK(names.error == Approx(0.25));
  CHECK(names.noise == 0);
  const std::vector<double> residual{0.02, -0.04}, small{0.001, -0.003};
  const Deviation invariant = deviation(Family::invariant, {residual, small, small});
  CHECK(invariant.error == Approx(0.03));
  CHECK(invariant.noise == Approx(0.002));
}

TEST_CASE("The size that 80 % of the mass passes") {
  const std::vector<double> sizes{0.03, 0.01, 0.02}, masses{2, 1, 1};
  // Middles of the shares by rising size: 1/8, 3/8, 3/4. 80 % lies beyond the last: the largest.
  CHECK(passing_size(sizes, masses, 0.8) == Approx(0.03));
  CHECK(passing_size(sizes, masses, 0.5) == Approx(0.02 + 0.01 / 3));
  CHECK(passing_size(sizes, masses, 0.25) == Approx(0.015));
  CHECK(passing_size(sizes, masses, 0.05) == Approx(0.01));
}

TEST_CASE("The force at the first break is extrapolated from the windows before it") {
  FirstBreak first;
  CHECK(std::isnan(first.time()));
  const double dt = 1e-6;
  const auto window = [&](int k) { return Window{10 * k, 10, dt}; };
  for (int k = 0; k < 3; ++k) first.see(window(k), 100 * (k + 0.5), {});  // 100 N more in each window
  CHECK_FALSE(first.seen());
  const Breakage later{36e-6, BreakMode::tension, {0, 0, 0}, 0, 3, 4, 0},
      sooner{34e-6, BreakMode::shear, {0, 0, 0}, 0, 9, 2, 0};
  first.see(window(3), 1e9, {sooner, later});
  REQUIRE(first.seen());
  CHECK(first.time() == Approx(34e-6));
  CHECK(first.force() == Approx(340));
  CHECK(first.bond() == 2 * 67108864.0 + 9);
  first.see(window(4), 0, {later});
  CHECK(first.time() == Approx(34e-6));
}

TEST_CASE("Skins of neighbour lists change no value, but the step does") {
  const AccuracyScene& scene = accuracy_scenes().front();
  REQUIRE(scene.name == "platen");
  const auto member = [&](KnobSetting setting) {
    setting.overrides.push_back("time.duration=5 ms");  // the first bonds have broken
    return run_member({&scene, scene_folder(), setting, 1});
  };
  KnobSetting wide = default_setting();
  wide.margin = 2;
  KnobSetting finer = default_setting();
  finer.overrides = {"time.safety=0.35"};
  const MemberResult a = member(default_setting()), b = member(wide), c = member(finer);
  REQUIRE_FALSE(std::isnan(a.values.at("first_break_time")));
  CHECK(a.values == b.values);
  CHECK(a.values.at("energy_per_mass") != c.values.at("energy_per_mass"));
  CHECK(c.time_step < 0.6 * a.time_step);
  CHECK(c.values.at("first_break_time") == Approx(a.values.at("first_break_time")).epsilon(0.02));
  CHECK(a.cpu_seconds > 0);
  CHECK(a.simulated_seconds == Approx(5e-3));
}

TEST_CASE("bench accuracy --json prints points of the documented form, and skins have an error of exactly 0") {
  const Workplace place;
  const AccuracyScene scene = short_platen(place.path());
  const std::vector<std::string> before = place.listing();
  const Outcome outcome = place.gyrosim("bench accuracy --folder . --quick --scene platen --json");
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const nlohmann::json all = nlohmann::json::parse(outcome.out);
  std::map<std::string, std::set<std::string>> metrics;  // by knob
  for (const nlohmann::json& p : all.at("points")) {
    INFO(p.dump());
    CHECK(p.at("scene") == "platen");
    CHECK(p.at("value").is_number());
    CHECK(p.at("seconds_per_simulated_second").get<double>() > 0);
    CHECK(p.contains("error_se"));
    CHECK(p.contains("noise"));
    metrics[p.at("knob").get<std::string>()].insert(p.at("metric").get<std::string>());
    if (p["knob"] == "margin") CHECK(p.at("error") == 0.0);
    if (p["knob"] == "step" && p["metric"] == "first_break_time") {
      CHECK(p.at("error").get<double>() > 0);
      CHECK(p.at("error").get<double>() < 2e-3);
    }
  }
  for (const char* knob : {"step", "substeps", "margin"}) CHECK(metrics[knob].size() == scene.metrics.size());
  CHECK(place.listing() == before);

  // A reference of the scene as it was.
  const fs::path reference = place.path() / "reference.json", file = place.path() / "platen.yaml";
  CHECK(read_reference(reference, scene, place.path()).seeds == 2);
  place.write("platen.yaml", read_text(file) + "# a comment changes nothing\n");
  CHECK(read_reference(reference, scene, place.path()).seeds == 2);
  place.write("platen.yaml", read_text(file) + "gravity: [0, 0, -9.8]\n");
  CHECK_THROWS_WITH(read_reference(reference, scene, place.path()),
                    Catch::Matchers::Contains("was made with another case"));
}

TEST_CASE("Errors of bench accuracy say what to do") {
  const Workplace place;
  const Outcome scene = place.gyrosim("bench accuracy --scene wegde --json");
  CHECK(scene.code == 2);
  CHECK(scene.err.find("use one of platen, wedge, crusher") != std::string::npos);
  CHECK(scene.out.empty());
  CHECK(place.gyrosim("bench accuracy --knob damping").code == 2);
  CHECK(place.gyrosim("bench").code == 2);
  const Outcome none = place.gyrosim("bench accuracy --folder .");
  CHECK(none.code == 2);
  CHECK(none.err.find("--make-reference") != std::string::npos);
}
