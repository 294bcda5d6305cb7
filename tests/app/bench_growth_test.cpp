// SPDX-License-Identifier: GPL-3.0-or-later
// `gyrosim bench speed --growth`: its scenes, its ratios, and its shape.
#include "app/bench/speed/growth.hpp"
#include "tests/app/program.hpp"
#include "tests/catch.hpp"

using namespace gyro;
using namespace gyro::bench;

namespace {

SpeedResult result_of(std::int64_t particles, int threads, double seconds) {
  SpeedMeasurement m;
  m.particles = particles;
  m.steps = 100;
  m.bytes = 900 * particles;
  m.cpu_seconds = threads == 1 ? seconds : 99;
  m.wall_seconds = threads == 1 ? 99 : seconds;
  return {"S2r", threads, Precision::mixed, {m}};
}

}  // namespace

TEST_CASE("Growth takes four sizes up to the largest, with fewer steps of larger ones") {
  const std::vector<SpeedScene> all = growth_scenes(), some = growth_scenes(20000);
  REQUIRE(all.size() == 4);
  REQUIRE(some.size() == 2);
  CHECK(some[1].recipe.particles == 10000);
  CHECK(all[3].recipe.particles == 1000000);
  CHECK(all[0].timed == 400);
  CHECK(all[2].timed == 100);
  CHECK(all[3].timed == 20);
}

TEST_CASE("Growth gives the cost of a particle-step, its largest ratio and the speed-up of threads") {
  const std::vector<SpeedResult> results{result_of(1000, 1, 0.01), result_of(1000, 2, 0.008), result_of(10000, 1, 0.15),
                                         result_of(10000, 2, 0.08)};
  const std::vector<GrowthRow> rows = growth_of(results);
  REQUIRE(rows.size() == 4);
  CHECK(rows[0].nanoseconds == Approx(100));
  CHECK(rows[2].nanoseconds == Approx(150));
  CHECK(rows[0].speedup == 1);
  CHECK(rows[1].speedup == Approx(1.25));
  CHECK(rows[3].speedup == Approx(1.875));
  CHECK(rows[2].bytes == 900);
  CHECK(cost_ratio(rows, Precision::mixed, 1) == Approx(1.5));
  CHECK(cost_ratio(rows, Precision::mixed, 2) == Approx(1));
}

TEST_CASE("bench speed gives the growth alone where it is asked for") {
  const Workplace place;
  const Outcome outcome = place.gyrosim("bench speed --growth --particles 1000 --precision mixed --threads 1 --json");
  REQUIRE(outcome.code == 0);
  const nlohmann::json j = nlohmann::json::parse(outcome.out);
  CHECK(j.at("scenes").empty());
  CHECK(j.at("bond_ceiling").empty());
  REQUIRE(j.at("growth").at("sizes").size() == 1);
  for (const char* key : {"particles", "threads", "precision", "steps", "ns_per_particle_step", "bytes_per_particle",
                          "speedup", "setup_seconds"})
    CHECK(j.at("growth").at("sizes").at(0).contains(key));
  CHECK(j.at("growth").at("cost_ratios").at(0).at("cost_ratio") == 1);
}
