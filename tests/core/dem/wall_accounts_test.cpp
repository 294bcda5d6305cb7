// SPDX-License-Identifier: GPL-3.0-or-later
// What the last step of a window leaves to the next one.
#include "core/dem/wall_accounts.hpp"
#include "core/exec/cpu.hpp"
#include "tests/catch.hpp"

using namespace gyro;

TEST_CASE("What is carried over does its work at the speed of the next window", "[dem][walls]") {
  Cpu exec(1);
  WallAccounts<Cpu> accounts(1, false);
  const std::vector<WallEntry> entries{{0, 0, {0, 0}}};
  accounts.set_entries(1);
  // A force on the particle at a point, for a time that lies in the next window; the wall moves as it did before.
  const Vec3d force{30, -20, 50}, point{0.4, 0.1, -0.3};
  const double time = 2e-6, length = 1e-3;
  WallSum& left = accounts.booking().carried_over[0];
  left.force = cast<std::int64_t>((-time / wall_quantum) * force);
  left.torque = cast<std::int64_t>((-time / wall_quantum) * cross(point, force));
  left.work = static_cast<std::int64_t>(time / wall_quantum * 123);

  std::vector<WallPose> poses(1);
  poses[0] = {{0.2, 0.3, 0.1}, {1, 0, 0, 0}, {0.5, -1, 2}, {3, -4, 6}};
  const std::vector<Sphere> position{{point, 0.01}};
  const std::vector<ParticleId> id{0};
  accounts.carry_over(exec, entries, {position, id}, poses);
  poses[0].velocity = {1, 2, -3};
  poses[0].angular_velocity = {-5, 7, 1};
  accounts.begin_window(poses);
  accounts.close(exec, entries, {position, id}, poses, length);

  const Vec3d velocity = poses[0].velocity + cross(poses[0].angular_velocity, point - poses[0].origin);
  CHECK(accounts.loads()[0].work == Approx(time * dot(force, velocity)).epsilon(1e-6));
  CHECK(accounts.loads()[0].force.x == Approx(-force.x * time / length).epsilon(1e-6));
}
