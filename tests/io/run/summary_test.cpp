// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/run/summary.hpp"

#include "core/base/errors.hpp"
#include "tests/catch.hpp"
#include "tests/io/run/scratch.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

using namespace gyro;
using Catch::Matchers::Contains;

TEST_CASE("The summary contains all its members, and undefined ones are null") {
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
  for (const char* name : {"stalled", "particles", "bond_steps", "bonds_initial", "bonds_broken"}) {
    CAPTURE(name);
    CHECK(json[name].is_null());  // nobody has said it
  }
  CHECK_THAT(to_text(summary, "out"), !Contains("particles"));
}

TEST_CASE("A summary is found in a directory, and other files are not taken for one") {
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

TEST_CASE("The text shows only what applies to the run, and fits on a screen") {
  Summary summary;
  summary.status = RunStatus::done;
  summary.title = "Quickstart";
  summary.simulated_seconds = 2;
  summary.wall_seconds = 200;
  summary.particles = 12;
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

  summary.product_below_css.reset();  // outside the sieves
  CHECK_THAT(to_text(summary, "out"), Contains("  87 % below OSS\n"));
  summary.product_below_css = 0.41;
  summary.product_below_oss.reset();
  CHECK_THAT(to_text(summary, "out"), Contains("  41 % below CSS\n"));
}

TEST_CASE("The text says where the product ends, and what is estimated below") {
  Summary summary;
  summary.resolution = summary.finest_particle = 0.0052;
  CHECK_THAT(to_text(summary, "out"), Contains("  resolution        particles of 5.2 mm; finer product is unknown\n"));
  summary.finest_particle = 0.0031;
  CHECK_THAT(to_text(summary, "out"), Contains("particles of 3.1 to 5.2 mm; finer product is unknown\n"));
  summary.fines = FinesFigures{.law = "breakage",
                               .p80 = 0.14,
                               .p50 = 0.06,
                               .share = 0.08,
                               .released_energy_kwh_per_t = 0.012,
                               .t10 = 0.21,
                               .beyond_share = 0.0};
  summary.specific_energy_kwh_per_t = 0.24;
  const std::string estimated = to_text(summary, "out");
  for (const char* line :
       {"  resolution        particles of 3.1 to 5.2 mm; below 5.2 mm estimated, by the energy of breakage\n",
        "  with fines        P80 140 mm, P50 60 mm, 8 % finer than its particles\n",
        "  t10               21 %, mean of the product; bonds released 0.012 kWh/t, 5 % of the crushing energy\n"})
    CHECK_THAT(estimated, Contains(line));
  CHECK_THAT(estimated, !Contains("extrapolation"));
  summary.fines->beyond_share = 0.3;
  CHECK_THAT(to_text(summary, "out"), Contains("above 40 % for 30 % of the product: the estimate is an extrapolation"));
  summary.fines->law = "gates_gaudin_schuhmann";
  CHECK_THAT(to_text(summary, "out"), Contains("below 5.2 mm estimated, by a Gates-Gaudin-Schuhmann distribution\n"));

  const ScratchDirectory scratch;
  summary.steady = SteadyFigures{.p80_with_fines = Estimate{0.135, 0.002}};
  CHECK_THAT(to_text(summary, "out"), Contains("  with fines        P80 135 +- 2 mm, 8 % finer than its particles\n"));
  write_summary(summary, scratch.path());
  const Summary again = load_summary(scratch.path());
  CHECK(to_text(again, "out") == to_text(summary, "out"));
  CHECK(to_json(again) == to_json(summary));
}

TEST_CASE("A summary that was read back prints the same text") {
  const ScratchDirectory scratch;
  Summary s;
  s.status = RunStatus::stopped;
  s.reason = "the energy balance is off";
  s.title = "All figures";
  s.version = "1.0";
  s.device = "cpu";
  s.precision = "double";
  s.threads = 3;
  s.simulated_seconds = 1.0 / 3;
  s.wall_seconds = 1e4 / 3;
  s.particle_steps = 3000000000;
  s.bond_steps = 5000000000;
  s.time_step = 1e-6;
  s.time_step_limit = 2e-6;
  s.particles = 77;
  s.bonds_initial = 2000;
  s.bonds_broken = 501;
  double value = 0.1;
  for (std::optional<double>* figure :
       {&s.feed_mass, &s.discharged_mass, &s.escaped_mass, &s.escaped_fraction, &s.feed_waiting, &s.throughput_tph,
        &s.specific_energy_kwh_per_t, &s.p80, &s.p50, &s.product_below_css, &s.product_below_oss, &s.singles_share,
        &s.swell_of_crumbled, &s.mean_crushing_power, &s.energy_residual_fraction, &s.momentum_residual_fraction,
        &s.mass_residual_fraction, &s.max_overlap_ratio, &s.holdup_mass})
    *figure = (value += 1.0 / 7);
  s.stalled = true;
  s.choked = true;
  s.motor = MotorFigures{4.5, 240e3, 300e3, 410e3, 600e3, 0.4, 0.683};
  s.laboratory = LaboratoryFigures{.test = "platen",
                                   .size = 0.04,
                                   .broken_before = 2,
                                   .first_break_force = 100,
                                   .failure_force = 4000,
                                   .failure_displacement = 1e-3,
                                   .strength = 2e6};
  s.drive_events = {{0.1, "stalled"}, {0.2, "tripped"}};
  const auto same = [&] {
    write_summary(s, scratch.path());
    const Summary again = load_summary(scratch.path());
    CHECK(to_text(again, "out") == to_text(s, "out"));
    CHECK(to_json(again) == to_json(s));
  };
  same();
  s.not_steady = "the chamber is emptying";
  same();
  s.not_steady.reset();
  SteadyFigures& f = s.steady.emplace();
  f = {.from = 4.5, .gyrations = 24, .blocks = 10, .crushing_power = {210e3, 4200}, .throughput_tph = {3420, 41}};
  f.p80 = Estimate{0.142, std::nan("")};
  f.specific_energy_kwh_per_t = Estimate{0.06, 0.001};
  f.residence_time = 25;
  same();
  s = {};
  same();
  s.time_step = 1e-3;
  s.time_step_limit = std::numeric_limits<double>::infinity();  // null in the file
  write_summary(s, scratch.path());
  CHECK(to_text(load_summary(scratch.path()), "out") == to_text(s, "out"));
}

TEST_CASE("A file that is not a summary is refused with its path and what to do") {
  const ScratchDirectory scratch;
  CHECK_THROWS_WITH(load_summary(scratch.path()),
                    Contains("summary.json: does not exist; give the directory of a run"));
  for (const char* text : {"", "{\"status\":", "[1, 2]", "{\"status\": 3}", "{\"status\": \"odd\"}", "{}",
                           "{\"status\": \"done\", \"p80\": \"large\"}", "{\"status\": \"done\", \"steady\": 3}"}) {
    INFO(text);
    std::ofstream(scratch.path() / "summary.json") << text;
    CHECK_THROWS_AS(load_summary(scratch.path()), BadInput);
    CHECK_THROWS_WITH(load_summary(scratch.path()), Contains("summary.json: is not a summary of a") && Contains("; "));
  }
  std::ofstream(scratch.path() / "summary.json") << "{\"status\": \"done\", \"new\": [1]}";  // of another version
  CHECK(load_summary(scratch.path()).status == RunStatus::done);
}

TEST_CASE("The text marks the figures of a start-up, and shows a steady part with its errors") {
  Summary s;
  s.throughput_tph = 0.0123;
  s.p80 = 0.0142;
  s.mean_crushing_power = 51.5;
  s.specific_energy_kwh_per_t = 0.0147;
  s.feed_mass = 2.442;
  s.discharged_mass = 0.0064;
  CHECK_THAT(to_text(s, "out"), !Contains("start-up"));  // without a drive it is unknown
  s.not_steady = "the chamber is still filling";
  const std::string start_up = to_text(s, "out");
  for (const char* line : {"not steady        the chamber is still filling; the figures below are of the start-up\n",
                           "throughput        12.3 kg/h, start-up\n", "product P80       14.2 mm, start-up\n",
                           "crushing power    51.5 W, mean, start-up\n", "0.0147 kWh/t, start-up\n",
                           "fed               2.442 kg\n", "discharged        6.4 g\n"})
    CHECK_THAT(start_up, Contains(line));
  CHECK(nlohmann::json::parse(to_json(s))["not_steady"] == "the chamber is still filling");
  CHECK(nlohmann::json::parse(to_json(s))["steady"].is_null());

  s.not_steady.reset();
  SteadyFigures& f = s.steady.emplace();
  f.from = 4.5;
  f.gyrations = 24;
  f.blocks = 10;
  f.crushing_power = {210e3, 4200};
  f.throughput_tph = {3420, 41};
  f.p80 = Estimate{0.142, 0.0031};
  f.product_below_css = f.product_below_oss = Estimate{0.5, 0.01};
  s.motor = MotorFigures{4.5, 240e3, 300e3, 410e3, 600e3, 0.4, 0.683};
  const std::string steady = to_text(s, "out");
  for (const char* line : {"since 4.5 s: the figures below are of 24 gyrations, with standard errors from 10 blocks",
                           "throughput        3420 +- 41 t/h\n", "product P80       142 +- 3.1 mm\n",
                           "crushing power    210 +- 4.2 kW, mean\n", "50 % below OSS",
                           "240 kW mean, 300 kW 95 %, 410 kW peak; mean 40 %, peak 68.3 % of rated 600 kW\n"})
    CHECK_THAT(steady, Contains(line));
  CHECK_THAT(steady, !Contains("start-up") && !Contains("specific energy"));  // nothing was discharged since then
  const auto json = nlohmann::json::parse(to_json(s))["steady"];
  CHECK(json["throughput_tph"] == 3420);
  CHECK(json["throughput_tph_error"] == 41);
  CHECK(json["crushing_power_error"] == 4200);
  CHECK(json["specific_energy_kwh_per_t_error"].is_null());
}
