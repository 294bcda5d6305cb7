// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/wall_motion.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"

#include <functional>
#include <numbers>

using namespace gyro;

namespace {

constexpr double pi = std::numbers::pi;
const GyrationMotion crusher{0.0217, 4.2, 0.03};

/// Largest difference of the stated velocity of some body points and the pose's derivative in time
/// (central difference of fourth order).
double velocity_error(const std::function<WallPose(double)>& pose, double time) {
  const double h = 2e-4;
  double worst = 0;
  for (const Vec3d& body : {Vec3d{0.9, 0, 0}, Vec3d{0, 0.5, 1.0}, Vec3d{-0.3, 0.2, 4.2}, Vec3d{0, 0, 0}}) {
    const auto at = [&](double t) { return to_world(pose(t), body); };
    const Vec3d slope = 1 / (12 * h) * (8.0 * (at(time + h) - at(time - h)) - (at(time + 2 * h) - at(time - 2 * h)));
    const WallPose now = pose(time);
    worst = std::max(worst, norm(slope - velocity_at(now, at(time))));
  }
  return worst;
}

WallPose moved(decltype(Wall::motion) motion, double time) {
  return pose_of(Wall{"wall", PlaneShape{}, std::move(motion)}, time, {});
}

}  // namespace

TEST_CASE("The velocity of a gyration is the derivative of its pose") {
  const double speed = 3.1;
  const double spin = GENERATE(0.0, -0.37, 2.9);
  const double time = GENERATE(0.0, 0.4, 7.3);
  const auto pose = [&](double t) { return gyration_pose(crusher, {0.7 + speed * t, speed, 0.2 + spin * t, spin}); };
  CHECK(velocity_error(pose, time) < 1e-9);
}

TEST_CASE("In a gyration the lower end leans towards the eccentric angle and the pivot is at rest") {
  const double angle = GENERATE(0.0, 1.0, 2.5, -2.0);
  const WallPose pose = gyration_pose({0.0217, 4.2, 0}, {angle, 1, 0.3, 0});
  const Vec3d pivot = to_world(pose, {0, 0, 4.2});
  CHECK(norm(pivot - Vec3d{0, 0, 4.2}) < 1e-15 * 10);
  const Vec3d low = to_world(pose, {0, 0, 0});
  CHECK(low.x == Approx(0.0217 * std::cos(angle)).margin(1e-15));
  CHECK(low.y == Approx(0.0217 * std::sin(angle)).margin(1e-15));
  CHECK(norm(rotate(pose.orientation, Vec3d{0, 0, 1}) - mantle_axis(crusher, angle)) < 1e-15 * 4);
}

TEST_CASE("In a gyration the lift moves the body along its axis") {
  const MantleState state{0.9, 2, 0.1, 0.2};
  const Vec3d low = to_world(gyration_pose({0.0217, 4.2, 0}, state), {0.1, 0.2, 0.3});
  const Vec3d lifted = to_world(gyration_pose({0.0217, 4.2, 0.05}, state), {0.1, 0.2, 0.3});
  CHECK(norm(lifted - low - 0.05 * mantle_axis(crusher, 0.9)) < 1e-15 * 8);
}

TEST_CASE("A mantle locked to the eccentric rotates about z as a whole") {
  const double speed = 16.755, cos_tilt = mantle_axis(crusher, 0).z;
  const WallPose pose = gyration_pose(crusher, {1.1, speed, 1.1 * cos_tilt, speed * cos_tilt});
  CHECK(norm(pose.angular_velocity - Vec3d{0, 0, speed}) < 1e-13);
  // The pose then is Rz(theta) Ry(-b): its image of x stays in the plane of z and the axis.
  const Vec3d x = rotate(pose.orientation, Vec3d{1, 0, 0});
  CHECK(std::abs(x.x * std::sin(1.1) - x.y * std::cos(1.1)) < 1e-14);
}

TEST_CASE("A mantle without spin rotates by the solid angle of the cone of its axis") {
  const double drift = 1 - mantle_axis(crusher, 0).z;
  const Vec3d start = rotate(gyration_pose(crusher, {0, 1, 0, 0}).orientation, Vec3d{1, 0, 0});
  const Vec3d after = rotate(gyration_pose(crusher, {2 * pi, 1, 0, 0}).orientation, Vec3d{1, 0, 0});
  CHECK(std::asin(norm(cross(start, after))) == Approx(2 * pi * drift).epsilon(1e-9));
}

TEST_CASE("M9: the mantle returns to its start after 1e6 gyrations") {
  const double cycles = 1e6, angle = 2 * pi * cycles;
  const double cos_tilt = mantle_axis(crusher, 0).z;
  const WallPose start = gyration_pose(crusher, {0, 16.755, 0, 0});
  const WallPose end = gyration_pose(crusher, {angle, 16.755, -angle * (1 - cos_tilt), 0});
  double worst = 0;
  for (const Vec3d& body : {Vec3d{0.953, 0, 0}, Vec3d{0, 0.7, 0.75}, Vec3d{-0.244, 0, 3.2}})
    worst = std::max(worst, norm(to_world(end, body) - to_world(start, body)));
  CHECK(worst < 1e-9);
}

TEST_CASE("The velocity of each motion is the derivative of its pose") {
  const double time = GENERATE(0.0, 0.013, 2.1);
  const Vec3d axis = 1 / std::sqrt(14.0) * Vec3d{1, 2, 3};
  CHECK(velocity_error([](double t) { return moved(LinearMotion{{0.1, -2, 3}}, t); }, time) < 1e-9);
  CHECK(velocity_error([&](double t) { return moved(RotationMotion{axis, {1, 2, -3}, 1.7}, t); }, time) < 1e-9);
  CHECK(velocity_error([](double t) { return moved(CircularMotion{0.02, 1.3}, t); }, time) < 1e-9);
  CHECK(velocity_error([](double t) { return moved(Fixed{}, t); }, time) == 0);
}

TEST_CASE("A circular motion starts at the drawn position and returns to it") {
  const CircularMotion circle{0.01, 0.05};
  CHECK(norm(moved(circle, 0).origin) == 0);
  const WallPose quarter = moved(circle, 0.0125), half = moved(circle, 0.025);
  CHECK(norm(quarter.origin - Vec3d{0.01, 0.01, 0}) < 1e-16 * 10);
  CHECK(norm(half.origin - Vec3d{0, 0.02, 0}) < 1e-16 * 10);
  CHECK(norm(moved(circle, 0.05 * 1e6).origin) < 1e-12);
}

TEST_CASE("M7: a rotating wall moves with omega x r") {
  const WallPose pose = moved(RotationMotion{{0, 0, 1}, {0.5, 0, 0}, 10}, 0.77);
  const Vec3d v = velocity_at(pose, {0.8, 0.4, 0.1});
  CHECK(norm(v - Vec3d{-4, 3, 0}) < 1e-10);
}

TEST_CASE("Motions with impossible parameters are refused") {
  const auto check = [](decltype(Wall::motion) motion) { check_motion(Wall{"w", PlaneShape{}, std::move(motion)}); };
  CHECK_NOTHROW(check(crusher));
  CHECK_THROWS_AS(check(RotationMotion{{0, 0, 0}, {0, 0, 0}, 1}), BadInput);
  CHECK_THROWS_AS(check(CircularMotion{0.1, 0}), BadInput);
  CHECK_THROWS_AS(check(GyrationMotion{5, 4.2, 0}), BadInput);
  CHECK_THROWS_AS(check(GyrationMotion{0.02, -1, 0}), BadInput);
  CHECK_THROWS_AS(check(LinearMotion{{NAN, 0, 0}}), BadInput);
}

TEST_CASE("The path of a window gives the state at any time in it") {
  const MantleState s = mantle_at(MantlePath{1, 16, 2, -0.4}, 0.25);
  CHECK(s.angle == 5);
  CHECK(s.speed == 16);
  CHECK(s.spin_angle == 1.9);
  CHECK(s.spin == -0.4);
}
