// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/summary.hpp"

#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace gyro;
using Catch::Matchers::Contains;

TEST_CASE("The summary holds every fixed field, null where it is not defined") {
  Summary summary;
  summary.status = RunStatus::interrupted;
  summary.particle_steps = 3000000000;
  summary.p80 = 0.1;
  summary.throughput_tph = std::nan("");
  const auto json = nlohmann::json::parse(to_json(summary));
  for (const char* name : {"status",
                           "simulated_seconds",
                           "wall_seconds",
                           "particle_steps",
                           "bond_steps",
                           "time_step",
                           "time_step_limit",
                           "throughput_tph",
                           "specific_energy_kwh_per_t",
                           "p80",
                           "p50",
                           "product_below_css",
                           "product_below_oss",
                           "singles_share",
                           "swell_of_crumbled",
                           "bonds_initial",
                           "bonds_broken",
                           "energy_residual_fraction",
                           "momentum_residual_fraction",
                           "mass_residual_fraction",
                           "stalled",
                           "precision"}) {
    CAPTURE(name);
    CHECK(json.contains(name));
  }
  CHECK(json["status"] == "interrupted");
  CHECK(json["particle_steps"] == 3000000000);
  CHECK(json["p80"] == 0.1);
  CHECK(json["throughput_tph"].is_null());
  CHECK(json["specific_energy_kwh_per_t"].is_null());
  CHECK(json["stalled"] == false);
}

TEST_CASE("A written summary is found again, anything else is none") {
  const ScratchDirectory scratch;
  CHECK_FALSE(read_summary(scratch.path()));
  write_summary({.status = RunStatus::done, .title = "bad byte \xff", .simulated_seconds = 1.25}, scratch.path());
  const auto earlier = read_summary(scratch.path());
  REQUIRE(earlier);
  CHECK(earlier->status == "done");
  CHECK(earlier->simulated_seconds == 1.25);
  for (const char* text : {"", "{\"status\":", "[1, 2]", "{\"status\": 3}"}) {
    std::ofstream(scratch.path() / "summary.json") << text;
    CHECK_FALSE(read_summary(scratch.path()));
  }
}

TEST_CASE("The text shows what the run has and fits a screen") {
  Summary summary;
  summary.status = RunStatus::done;
  summary.title = "Quickstart";
  summary.simulated_seconds = 2;
  summary.wall_seconds = 200;
  summary.particle_steps = 1000000000;
  const std::string plain = to_text(summary, "runs/quickstart-001");
  CHECK_THAT(plain, Contains("Quickstart: done, 2 s simulated in 3 min 20 s"));
  CHECK_THAT(plain, Contains("5 M particle-steps/s"));
  CHECK_THAT(plain, Contains("runs/quickstart-001"));
  CHECK_THAT(plain, !Contains("bonds"));
  CHECK_THAT(plain, !Contains("P80"));

  summary.bonds_initial = 2000;
  summary.bonds_broken = 500;
  summary.p80 = 0.142;
  summary.product_below_css = 0.41;
  summary.product_below_oss = 0.87;
  summary.singles_share = 0.125;
  summary.swell_of_crumbled = 1.07;
  summary.throughput_tph = 3420;
  summary.energy_residual_fraction = 1e-4;
  const std::string full = to_text(summary, "out");
  CHECK_THAT(full, Contains("500 of 2000 broken (25 %)"));
  CHECK_THAT(full, Contains("142 mm"));
  CHECK_THAT(full, Contains("87 % below OSS, 41 % below CSS"));
  CHECK_THAT(full, Contains("12.5 % of the product; crumbled rock swells 1.07-fold"));
  CHECK_THAT(full, Contains("3420 t/h"));
  CHECK(std::count(full.begin(), full.end(), '\n') <= 20);
}
