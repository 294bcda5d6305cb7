// SPDX-License-Identifier: GPL-3.0-or-later
// Shorter windows at the drive's request: the power residual as an error indicator.
#include "app/verify/fixtures/drives.hpp"
#include "tests/catch.hpp"

#include <algorithm>

namespace gyro {
namespace {

using namespace fixtures;

/// Windows of the length that the drive asks for, against a spring whose stiffness may change.
struct AdaptiveRun {
  Drivetrain drivetrain;
  double longest, stiffness;
  double time = 0;
  void window() {
    const double length = longest / drivetrain.window_divisor();
    const Window window{.first_step = std::int64_t(std::llround(time / (longest / 256))),
                        .steps = int(std::llround(256 * length / longest)),
                        .dt = longest / 256};
    exchange(drivetrain, window, [&](double a, double b) { return stiffness * (a + b) / 2; });
    time = window.end();
  }
};

}  // namespace

TEST_CASE("Windows are halved until the residual is small, and doubled again when it allows", "[mbd][coupling]") {
  DrivetrainParameters light = shaft_on_spring(300);
  light.residual_limit = 0.02;
  AdaptiveRun run{Drivetrain(light), 5e-3, 5e6};
  while (run.time < 1) run.window();
  CHECK(run.drivetrain.window_divisor() >= 4);
  CHECK(run.drivetrain.window_divisor() <= 64);
  double residual = 0, passed = 0, fastest = 0;
  while (run.time < 1.5) {
    run.window();
    residual += std::abs(run.drivetrain.means().power_residual);
    passed += std::abs(run.drivetrain.means().crushing_power);
    fastest = std::max(fastest, std::abs(run.drivetrain.state().speed));
  }
  CHECK(residual < 0.03 * passed);
  CHECK(fastest < 1.02);  // it began at 1 rad/s, so the oscillation does not grow
  run.stiffness = 5e2;
  while (run.time < 4) run.window();
  CHECK(run.drivetrain.window_divisor() == 1);
}

TEST_CASE("The usual window of a crusher is not halved", "[mbd][coupling]") {
  DrivetrainParameters machine = crusher_62_75(paper_droop());
  machine.losses = {.no_load_power = 50e3, .load_factor = 0.05};
  machine.residual_limit = 0.02;
  Drivetrain drivetrain(machine);
  for (int k = 0; k < 2000; ++k) {
    exchange(drivetrain, window_number(k, 0.5e-3),
             [&](double begin, double end) { return 14e3 * (1 + std::sin(5 * (begin + end) / 2)); });
    REQUIRE(drivetrain.window_divisor() == 1);
  }
}

}  // namespace gyro
