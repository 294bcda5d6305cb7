// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of loose spheres that move together: neighbour lists go by absolute speed.
#include "app/bench/speed/own_process.hpp"
#include "app/bench/speed/process_memory.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "core/dem/make_dem.hpp"
#include "tests/catch.hpp"

#include <malloc.h>

using namespace gyro;
using namespace gyro::fixtures;

namespace {

constexpr int across = 30;  // spheres of a cube
constexpr double radius = 1.7e-3, dt = 1e-5;

/// Peak of the bytes of a particle when a cube of spheres that do not touch falls so many radii a step.
double bytes_when_falling(double radii_in_step, int steps) {
  const auto measured = bench::in_own_process([&]() -> nlohmann::json {
    const Scene scene = plain_scene(dt);
    std::vector<NewRock> spheres;
    for (int k = 0; k < across * across * across; ++k) {
      const Vec3d at{1.0 * (k % across), 1.0 * (k / across % across), 1.0 * (k / across / across)};
      spheres.push_back(
          sphere(static_cast<ParticleId>(k), 2.002 * radius * at, {0, 0, -radii_in_step * radius / dt}, radius, 2600));
    }
    const std::int64_t before = bench::resident_bytes();
    const auto dem = make_cpu_dem(scene, Precision::mixed, 1);
    dem->insert(spheres);
    spheres.clear();
    ::malloc_trim(0);
    std::int64_t step = 0;
    run(*dem, dt, step, steps);
    return bench::peak_resident_bytes() - before;
  });
  return static_cast<double>(measured.get<std::int64_t>()) / (across * across * across);
}

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they take memory of their own
TEST_CASE("Spheres that fall together take at most three times the memory of spheres at rest, at any speed") {
  // 675 bytes at rest, 940 at 0.06 radii a step, and 1750 at 0.15 and 0.19; 3090 there with lists of at least three
  // steps.
  const double at_rest = bytes_when_falling(0, 60);
  CHECK(at_rest > 300);
  for (const double speed : {0.06, 0.19}) {
    CAPTURE(speed, at_rest);
    CHECK(bytes_when_falling(speed, 60) < 3 * at_rest);
  }
}
#endif
