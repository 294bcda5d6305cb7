// SPDX-License-Identifier: GPL-3.0-or-later
// The torques of the rock on the drive by virtual work.
#include "mbd/mantle_load.hpp"

#include "core/math/random.hpp"
#include "core/scene/wall_motion.hpp"
#include "tests/catch.hpp"

#include <cmath>

namespace gyro {
namespace {

double between(double low, double high, std::uint64_t thing, std::uint32_t draw) {
  return low + (high - low) * uniform(7, Stream::place, thing, draw);
}

Vec3d vector_in(double size, std::uint64_t thing, std::uint32_t draw) {
  return {between(-size, size, thing, 3 * draw), between(-size, size, thing, 3 * draw + 1),
          between(-size, size, thing, 3 * draw + 2)};
}

}  // namespace

TEST_CASE("Power of random forces on the moving mantle is torque times speed", "[mbd][mantle]") {
  constexpr std::uint32_t trials = 50, forces = 20;
  for (std::uint64_t trial = 0; trial < trials; ++trial) {
    const GyrationMotion motion{between(0.001, 0.1, trial, 900), between(0.5, 5, trial, 901),
                                between(-0.05, 0.05, trial, 902)};
    const MantleState mantle{between(-10, 10, trial, 903), between(-20, 20, trial, 904), between(-10, 10, trial, 905),
                             between(-20, 20, trial, 906)};
    const WallPose pose = gyration_pose(motion, mantle);
    WallLoad wall;  // of all forces, about the world's origin
    double power = 0, size = 0;
    for (std::uint32_t k = 0; k < forces; ++k) {
      const Vec3d point = to_world(pose, vector_in(2, trial, 2 * k)), force = vector_in(1e5, trial, 2 * k + 1);
      wall.force += force;
      wall.torque += cross(point, force);
      power += dot(force, velocity_at(pose, point));
      size += std::abs(dot(force, velocity_at(pose, point)));
    }
    MantleWrench rock;
    rock.add(wall, motion.pivot_height);
    const MantleLoad load = mantle_load(rock, mantle_axis(motion, mantle.angle), 0);
    CAPTURE(trial, power, load.resisting_torque, load.spin_torque);
    REQUIRE(size > 0);
    CHECK(std::abs(-load.resisting_torque * mantle.speed + load.spin_torque * mantle.spin - power) < 1e-12 * size);
  }
}

TEST_CASE("A force through the pivot loads neither the eccentric nor the spin", "[mbd][mantle]") {
  const GyrationMotion motion{0.05, 4.0, 0};
  const Vec3d force{1e5, -2e5, 3e5}, pivot{0, 0, motion.pivot_height};
  MantleWrench rock;
  rock.add({.force = force, .torque = cross(pivot, force), .work = 7}, motion.pivot_height);
  const MantleLoad load = mantle_load(rock, mantle_axis(motion, 0.3), 1.0);
  CHECK(load.work == 7);
  CHECK(load.resisting_torque == Approx(0).margin(1e-9));
  CHECK(load.spin_torque == Approx(0).margin(1e-9));
  CHECK(load.bearings.bushing == Approx(0).margin(1e-9));
}

TEST_CASE("A force at the discharge plane that pushes the mantle back resists by force times arm", "[mbd][mantle]") {
  // At azimuth 0 the mantle is nearest at +x and moves towards +y there. A force F along -y at (r, 0, 0) has the arm of
  // the axis, e at the discharge plane: the axis is at (e, 0, 0) and moves at e theta' along +y.
  const GyrationMotion motion{0.02, 4.0, 0};
  const double force = 3e5;
  const Vec3d axis = mantle_axis(motion, 0);
  const Vec3d on_axis = Vec3d{0, 0, motion.pivot_height} + (-motion.pivot_height / axis.z) * axis;
  MantleWrench rock;
  rock.add({.force = {0, -force, 0}, .torque = cross(on_axis, Vec3d{0, -force, 0})}, motion.pivot_height);
  const MantleLoad load = mantle_load(rock, axis, 0);
  const double arm = std::hypot(on_axis.x, on_axis.y);
  CHECK(arm == Approx(0.02).epsilon(1e-4));
  CHECK(load.resisting_torque == Approx(force * arm).epsilon(1e-4));
  CHECK(load.spin_torque == Approx(0).margin(1e-6 * force));
}

TEST_CASE("Loads of several gyrating walls add up", "[mbd][mantle]") {
  const WallLoad a{.force = {1, 2, 3}, .torque = {4, 5, 6}, .work = 7},
      b{.force = {-3, 1, 4}, .torque = {1, -5, 9}, .work = 2};
  MantleWrench both;
  both.add(a, 2.0);
  both.add(b, 2.0);
  CHECK(both.work == 9);
  CHECK(both.force.x == -2);
  CHECK(both.torque.x == Approx(4 + 1 + 2.0 * 3));  // -(z x F).x = pivot height times F.y
  CHECK(both.torque.y == Approx(5 - 5 - 2.0 * -2));
  CHECK(both.torque.z == Approx(15));
}

}  // namespace gyro
