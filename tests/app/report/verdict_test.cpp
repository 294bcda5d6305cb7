// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/verdict.hpp"
#include "tests/catch.hpp"

#include <algorithm>

using namespace gyro;
using namespace gyro::report;
using Catch::Matchers::Contains;

namespace {

RunData crusher() {
  RunData run;
  run.summary.status = RunStatus::done;
  run.summary.simulated_seconds = 4;
  run.summary.mean_crushing_power = 100;
  run.summary.steady = SteadyFigures{.from = 1.2, .gyrations = 20, .blocks = 10};
  run.summary.energy_residual_fraction = 0.002;
  return run;
}

std::string all_trust(const Verdict& v) {
  std::string text;
  for (const std::string& sentence : v.trust) text += sentence + "\n";
  return text;
}

}  // namespace

TEST_CASE("A steady run is good, and says over how much it is averaged") {
  const Verdict v = verdict(crusher());
  CHECK(v.tone == Verdict::Tone::good);
  CHECK(v.headline == "Steady since 1.20\u00a0s");
  CHECK_THAT(v.lead, Contains("20 gyrations"));
  CHECK_THAT(all_trust(v), Contains("10 blocks") && Contains("0.200\u00a0%") && Contains("not been validated"));
}

TEST_CASE("A steady part of few gyrations asks for caution") {
  RunData run = crusher();
  run.summary.steady->gyrations = 19;
  const Verdict v = verdict(run);
  CHECK(v.tone == Verdict::Tone::caution);
  CHECK_THAT(all_trust(v), Contains("Fewer than 20 gyrations"));
}

TEST_CASE("A stall stays the worst that is said of a run that was interrupted") {
  RunData run = crusher();
  run.summary.stalled = true;
  run.summary.status = RunStatus::interrupted;
  CHECK(verdict(run).tone == Verdict::Tone::bad);
}

TEST_CASE("A start-up has no steady figures") {
  RunData run = crusher();
  run.summary.steady.reset();
  run.summary.not_steady = "the chamber is still filling";
  const Verdict v = verdict(run);
  CHECK(v.tone == Verdict::Tone::caution);
  CHECK_THAT(v.headline, Contains("start-up") && Contains("no steady figures"));
  CHECK_THAT(all_trust(v), Contains("the chamber is still filling"));
}

TEST_CASE("What went wrong comes first") {
  RunData run = crusher();
  run.summary.choked = true;
  CHECK(verdict(run).headline == "Choked: Steady since 1.20\u00a0s");
  CHECK(verdict(run).tone == Verdict::Tone::caution);
  run.summary.stalled = true;
  CHECK(verdict(run).tone == Verdict::Tone::bad);
  CHECK(verdict(run).headline == "Choked: Stalled: the rock stopped the drive");
  run.summary.drive_events = {{0.5, "stall"}, {0.7, "under-speed trip"}};
  CHECK_THAT(verdict(run).headline, Contains("Stalled at 0.500\u00a0s"));
  run.summary.status = RunStatus::interrupted;
  run.summary.reason = "signal 15";
  CHECK_THAT(verdict(run).headline, Catch::Matchers::StartsWith("Interrupted"));
  CHECK_THAT(verdict(run).trust.front(), Contains("signal 15"));
  run.summary.status = RunStatus::stopped;
  CHECK(verdict(run).headline == "Stopped by a guard: do not use these figures");
  run.summary.status = RunStatus::failed;
  CHECK(verdict(run).tone == Verdict::Tone::bad);
}

TEST_CASE("An energy balance that is off is said so") {
  RunData run = crusher();
  run.summary.energy_residual_fraction = -0.03;
  const Verdict v = verdict(run);
  CHECK(v.tone == Verdict::Tone::caution);
  CHECK_THAT(all_trust(v), Contains("3.00\u00a0%") && Contains("more than usual"));
}

TEST_CASE("A product as fine as the particles says more of them than of the crusher") {
  RunData run = crusher();
  run.summary.resolution = 0.0138;
  run.summary.discharged_mass = 1;
  run.summary.steady->p80 = Estimate{0.0146, 1e-4};
  CHECK_THAT(all_trust(verdict(run)), Contains("P80 lies close to that size"));
  run.summary.steady->p80 = Estimate{0.1, 1e-3};
  CHECK_THAT(all_trust(verdict(run)), !Contains("P80 lies close"));
}

TEST_CASE("A laboratory test and a plain scene have verdicts of their own") {
  RunData run;
  run.summary.status = RunStatus::done;
  run.summary.simulated_seconds = 0.5;
  CHECK(verdict(run).headline == "0.500\u00a0s simulated");
  run.summary.laboratory = LaboratoryFigures{.test = "platen", .size = 0.05};
  CHECK_THAT(verdict(run).headline, Contains("the rock did not fail"));
  run.summary.laboratory->strength = 9.91e5;
  CHECK(verdict(run).headline == "Laboratory test (platen): strength 991\u00a0kPa");
}
