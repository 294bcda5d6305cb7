// SPDX-License-Identifier: GPL-3.0-or-later
// Steps that a device takes while the host does not look.
#include "tests/gpu/mirror.hpp"
#include "tests/gpu/same_bits.hpp"

#include "core/base/errors.hpp"

#include <array>

using namespace gyro;
using namespace gyro::test;

namespace {

Outcome on_mirror(const Scene& scene, int max_steps_ahead) {
  DeviceMemory::instance().forget();
  DemSolver<Mirror, float> dem(scene, Mirror(max_steps_ahead));
  return break_rocks(dem);
}

/// How often a limit was passed in a window at whose end it was not.
int passed_inside(const Outcome& limited, const Outcome& free) {
  int count = 0;
  for (std::size_t w = 0; w < limited.extremes.size(); ++w)
    count += limited.extremes[w].overlap_ratio > free.extremes[w].overlap_ratio;
  return count;
}

/// Batches of the steps (done, steps] if nothing halts.
int batches(BatchSize size, int done, int steps) {
  int count = 0;
  for (; done < steps; ++count) {
    const int n = std::min(size.steps(), steps - done);
    size.passed(n);
    done += n;
  }
  return count;
}

/// What the host reads in a window of this many steps, in which two spheres fly.
Traffic traffic_of_flight(int steps, int max_steps_ahead, double speed_limit = 1) {
  Scene scene = plain_scene(1e-7);
  scene.limits.speed_ratio = speed_limit;
  scene.walls.push_back(floor_plane());
  DeviceMemory::instance().forget();
  DemSolver<Mirror, float> dem(scene, Mirror(max_steps_ahead));
  dem.insert(std::array{sphere(0, {0, 0, 1}, {1, 0, 0}, 0.01, 2600), sphere(1, {0, 0, 2}, {1, 0, 0}, 0.01, 2600)});
  dem.advance({.first_step = 0, .steps = 1, .dt = 1e-7}, {});
  const Traffic before = Mirror::counts;
  dem.advance({.first_step = 1, .steps = steps, .dt = 1e-7}, {});
  REQUIRE(dem.counts().rebuilds == 1);
  return {.reads = Mirror::counts.reads - before.reads, .bytes_read = Mirror::counts.bytes_read - before.bytes_read};
}

}  // namespace

TEST_CASE("Steps ahead of the host have the bits of steps that are watched one by one", "[gpu]") {
  Scene scene = breaking_scene();
  const int most = GENERATE(1, 7);  // 1000 in mirror_test.cpp
  scene.substeps = most == 1 ? 3 : 1;
  const Outcome cpu = break_rocks(*make_cpu_dem(scene, Precision::mixed, 1));
  require_busy(cpu);
  check_same(cpu, on_mirror(scene, most));
}

TEST_CASE("Steps ahead stop at the step that passes a limit, once in a window", "[gpu]") {
  Scene scene = breaking_scene();
  const Outcome free = break_rocks(*make_cpu_dem(scene, Precision::mixed, 1));
  scene.limits.overlap_ratio = 0.07;
  const Outcome cpu = break_rocks(*make_cpu_dem(scene, Precision::mixed, 1));
  REQUIRE(passed_inside(cpu, free) > 5);
  REQUIRE(passed_inside(cpu, free) < 40);  // of 48
  check_same(cpu, on_mirror(scene, 1000));
}

TEST_CASE("The host reads once in a batch of steps, 8 bytes, and nothing between them", "[gpu]") {
  // Anything but launches within a batch is an error of the mirror.
  const int most = GENERATE(1, 10, 1000);
  BatchSize size(most);
  size.passed(1);  // the first window
  const int one = batches(size, 0, 1), many = batches(size, 0, 400);
  CHECK(one == 1);
  CHECK(many == (most == 1 ? 400 : most == 10 ? 43 : 22));
  const Traffic short_window = traffic_of_flight(1, most), long_window = traffic_of_flight(400, most);
  CHECK(long_window.reads - short_window.reads == many - one);
  CHECK(long_window.bytes_read - short_window.bytes_read == 8 * (many - one));
}

TEST_CASE("Steps beyond a limit stop a device once in a window", "[gpu]") {
  const double passed = 1e-9;  // by all steps: they have 1e-5
  CHECK(traffic_of_flight(400, 1000, passed).reads < traffic_of_flight(400, 1000).reads + 60);
}

TEST_CASE("A scene tells what has passed between host and device, and nothing without a device", "[gpu]") {
  CHECK(make_cpu_dem(plain_scene(1e-7), Precision::mixed, 1)->traffic().empty());
  DeviceMemory::instance().forget();
  const DemSolver<Mirror, float> dem(plain_scene(1e-7), Mirror{});
  const auto counts = static_cast<const Dem&>(dem).traffic();
  REQUIRE(counts.size() == 8);
  CHECK(counts[0] == std::pair<std::string, std::int64_t>("launches", Mirror::counts.launches));
  CHECK(counts[4] == std::pair<std::string, std::int64_t>("reads", Mirror::counts.reads));
}

TEST_CASE("A window on a device is asked for once a batch whether it is given up", "[gpu]") {
  DeviceMemory::instance().forget();
  DemSolver<Mirror, float> dem(plain_scene(1e-7), Mirror(50));
  dem.insert(std::array{sphere(0, {0, 0, 1}, {1, 0, 0}, 0.01, 2600)});
  std::vector<double> asked;
  dem.give_up_when([&](double done) {
    asked.push_back(done);
    return done > 0.5;
  });
  CHECK_THROWS_AS(dem.advance({.first_step = 0, .steps = 1000, .dt = 1e-7}, {}), WindowGivenUp);
  CHECK(asked.size() < 40);
  CHECK(std::is_sorted(asked.begin(), asked.end()));
  CHECK(asked.back() < 0.56);
}

TEST_CASE("Batches grow with the steps between halts, up to the most that is allowed", "[gpu]") {
  BatchSize size(20);
  CHECK(size.steps() == 2);
  size.passed(16);
  CHECK(size.steps() == 8);
  size.passed(1000);
  CHECK(size.steps() == 20);
  size.halted(0);
  CHECK(size.steps() == 20);  // the next halt is expected as late
  size.passed(3);
  size.halted(1);
  CHECK(size.steps() == 4);
  CHECK(BatchSize(0).steps() == 1);
}
