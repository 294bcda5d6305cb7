// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of particles, by their speed.
#include "core/kernels/bounds.hpp"

#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

using namespace gyro;

namespace {

constexpr double dt = 1e-5;
constexpr Ways wide{100 * dt, 0.5, 0.1, 4, 0}, close_by{10 * dt, 0.5, 0.01, 1, 0};

/// Spheres of 10 mm with given velocities along x and two sub-steps in a step, and their bounds.
struct Spheres {
  std::vector<Sphere> position, wide_bound, close_bound;
  std::vector<Motion> motion;
  std::vector<double> step;

  explicit Spheres(const std::vector<double>& velocities)
      : position(velocities.size(), Sphere{{1, 2, 3}, 0.01}),
        wide_bound(velocities.size()),
        close_bound(velocities.size()),
        step(velocities.size(), dt / 2) {
    for (const double v : velocities) motion.push_back({{v, 0, 0}, 1});
    const SetWideBounds set{read(), dt, wide, wide_bound.data()};
    for (std::size_t n = 0; n < position.size(); ++n) set(static_cast<Index>(n));
  }
  ConstParticleView read() const {
    ConstParticleView p{};
    p.position = position.data();
    p.motion = motion.data();
    p.step = step.data();
    return p;
  }
  SetCloseBounds closer() { return {read(), dt, close_by, wide_bound.data(), close_bound.data()}; }
};

}  // namespace

TEST_CASE("A way is the time times the speed, within limits by radius", "[kernels]") {
  const Sphere sphere{{0, 0, 0}, 0.01};
  CHECK(wide.of(sphere, {0, 3, 4}) == Approx(100 * dt * 5.5));
  CHECK(wide.of(sphere, {0, 0, 0}) == Approx(0.1 * 0.01));
  CHECK(wide.of(sphere, {1e6, 0, 0}) == 4 * 0.01);
  CHECK(wide.of(sphere, {std::numeric_limits<double>::quiet_NaN(), 0, 0}) == 4 * 0.01);
  Ways given = wide;
  given.given = 0.002;
  CHECK(given.of(sphere, {1e6, 0, 0}) == 0.002);
}

TEST_CASE("A bound is left when contacts see the particle outside it", "[kernels]") {
  const Vec3d centre{1, 2, 3};
  CHECK_FALSE(has_left(centre, 0.012, {1.001999, 2, 3}, 0.01));
  CHECK(has_left(centre, 0.012, {1.002001, 2, 3}, 0.01));
  // Half of what a step has over a sub-step ahead.
  Spheres fast({200});
  CHECK(fast.wide_bound[0].x.x == Approx(1 + 200 * dt / 4).epsilon(1e-14));
  CHECK(seen_centre(fast.position[0].x, fast.motion[0].v, dt, fast.step[0]).x == fast.wide_bound[0].x.x);
}

TEST_CASE("Close bounds are by speed and end where the wide ones end", "[kernels]") {
  Spheres spheres({0, 2, 5, 20});
  spheres.position[1].x.y += 0.0024;  // of 2.5 mm
  spheres.position[2].x.z -= 0.0054;  // of 5.5 mm
  const SetCloseBounds set = spheres.closer();
  Room room;
  for (Index n = 0; n < 4; ++n) {
    set(n);
    const auto k = static_cast<std::size_t>(n);
    const Sphere &outer = spheres.wide_bound[k], &inner = spheres.close_bound[k];
    CAPTURE(n);
    CHECK(norm(inner.x - outer.x) + inner.radius <= outer.radius);
    room = room + RoomIn{set}(n);
  }
  CHECK(spheres.close_bound[0].radius - 0.01 == Approx(0.01 * 0.01).epsilon(1e-9));
  const double ahead = dt / 4;  // of a metre per second
  CHECK(spheres.close_bound[1].radius - 0.01 == Approx(0.0001 + 2 * ahead).epsilon(1e-4));
  CHECK(spheres.close_bound[3].radius - 0.01 == Approx(10 * dt * 20.5 + 20 * ahead).epsilon(1e-9));
  CHECK(room.smallest == Approx((0.0001 + 5 * ahead) / (10 * dt * 5.5)).epsilon(1e-4));  // of the third
  spheres.position[1].x.y += 0.0002;                                                     // out of its wide bound
  set(1);
  CHECK(spheres.close_bound[1].radius == 0.01);
  CHECK(RoomIn{set}(1).smallest == 0);
}

TEST_CASE("Lists hold for the numbers of steps that cost least", "[kernels]") {
  for (const double g : {0.002, 0.005, 0.01}) {
    CAPTURE(g);
    const ListSteps steps = steps_of_lists(g);
    const auto cost_close = [g](double t) { return std::pow(1 + g * t, 3) * (1 + 12 / t); };
    const auto cost_wide = [g, &steps](double t) { return std::pow(1 + g * t, 3) * (1 / steps.close + 10 / t); };
    double min_close = 1e300, min_wide = 1e300;
    for (double t = 1; t < 2000; t *= 1.01) {
      min_close = std::min(min_close, cost_close(t));
      min_wide = std::min(min_wide, cost_wide(t));
    }
    CHECK(cost_close(steps.close) < 1.001 * min_close);
    CHECK(cost_wide(steps.wide) < 1.001 * min_wide);
  }
  CHECK(steps_of_lists(0).close == 60);
  CHECK(steps_of_lists(0).wide == 400);
  CHECK(steps_of_lists(10).close == 1);
  CHECK(steps_of_lists(10).wide == 2);
}

TEST_CASE("Bounds stay within half a radius and a radius on average, however fast all particles are", "[kernels]") {
  for (double g = 1e-4; g < 0.5; g *= 1.1) {
    CAPTURE(g);
    const ListSteps steps = steps_of_lists(g);
    CHECK(g * steps.close <= 0.5);
    CHECK(g * steps.wide <= 1);
  }
}
