// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernels/enter_step.hpp"

#include "tests/catch.hpp"

#include <array>

using namespace gyro;

TEST_CASE("A step counts itself, brings the walls to its end, and halts where the host must act", "[kernels]") {
  std::array<WallPose, 6> rows;  // two walls, begin and two steps
  for (int k = 0; k < 6; ++k) rows[static_cast<std::size_t>(k)].origin.x = k;
  std::array<WallPose, 2> now{};
  StepFlags flags{};
  StepProgress progress{};
  EnterStep enter{
      .walls = {rows.data(), now.data(), 2}, .flags = &flags, .progress = &progress, .limits = true, .stop_at = 100};
  const auto halts = [&] {
    progress = {1, 0};
    enter(0);
    return progress.halted != 0;
  };
  CHECK_FALSE(halts());
  CHECK(progress.step == 2);
  CHECK(now[0].origin.x == 4);
  CHECK(now[1].origin.x == 5);
  flags.failures = 3;
  CHECK_FALSE(halts());
  for (const auto flag : {&StepFlags::moved_too_far, &StepFlags::block_cracked, &StepFlags::limit_exceeded}) {
    flags = StepFlags{};
    flags.*flag = 1;
    CHECK(halts());
  }
  enter.limits = false;
  CHECK_FALSE(halts());
  enter.stop_at = 2;
  CHECK(halts());
  enter.stop_at = 3;
  CHECK_FALSE(halts());
}
