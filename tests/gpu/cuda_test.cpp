// SPDX-License-Identifier: GPL-3.0-or-later
// Without a device: the error that a user gets. With one: the bits of the CPU.
#include "gpu/check_cuda.hpp"
#include "gpu/make_cuda_dem.hpp"
#include "tests/gpu/same_bits.hpp"

#include "core/base/errors.hpp"

#include <cstdlib>

using namespace gyro;
using namespace gyro::test;

TEST_CASE("Without a device the error says why and what to do", "[gpu]") {
  if (cuda_device_is_there()) {
    WARN("skipped: there is a device; " + cuda_device_report());
    return;
  }
  std::string message;
  try {
    make_cuda_dem(plain_scene(1e-6), Precision::mixed);
  } catch (const NoDevice& error) {
    message = error.what();
  }
  INFO(message);
  CHECK(message.find("looking for a device") != std::string::npos);
  CHECK(message.find("--device cpu") != std::string::npos);
}

TEST_CASE("GYRO_CUDA_AHEAD is a number of steps", "[gpu]") {
  const char* before = std::getenv("GYRO_CUDA_AHEAD");
  const std::string kept = before == nullptr ? "" : before;
  for (const char* bad : {"", "0", "-3", "many", "5 steps", "1000001"}) {
    setenv("GYRO_CUDA_AHEAD", bad, 1);
    CHECK_THROWS_AS(max_steps_ahead(), BadInput);
  }
  setenv("GYRO_CUDA_AHEAD", "64", 1);
  CHECK(max_steps_ahead() == 64);
  unsetenv("GYRO_CUDA_AHEAD");
  CHECK(max_steps_ahead() == 1'000'000);
  if (before != nullptr) setenv("GYRO_CUDA_AHEAD", kept.c_str(), 1);
}

TEST_CASE("A device gives the bits of the CPU", "[gpu]") {
  if (!cuda_device_is_there()) {
    WARN("skipped: " + cuda_device_report());
    return;
  }
  const Precision precision = GENERATE(Precision::mixed, Precision::double_);
  const Outcome cpu = break_rocks(*make_cpu_dem(breaking_scene(), precision, 2));
  require_busy(cpu);
  check_same(cpu, break_rocks(*make_cuda_dem(breaking_scene(), precision)));
}
