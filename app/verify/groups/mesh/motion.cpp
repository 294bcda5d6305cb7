// SPDX-License-Identifier: GPL-3.0-or-later
// Moving walls, and the loads on walls (M6 to M9).
#include "app/verify/fixtures/held_sphere.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/meshes.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"
#include "core/scene/wall_motion.hpp"
#include "core/walls/liners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double radius = 0.01, g = 9.81;
const Material rock = soft_rock();

/// Three spheres that are bonded in a triangle, so that they cannot roll.
NewRock sledge(ParticleId first, const Vec3d& middle) {
  NewRock rock_of_three;
  rock_of_three.id = 0;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * pi * k / 3, r = 2 * radius / std::sqrt(3.0);
    rock_of_three.particles.push_back({first + static_cast<ParticleId>(k),
                                       middle + r * Vec3d{std::cos(angle), std::sin(angle), 0},
                                       {0, 0, 0},
                                       {0, 0, 0},
                                       radius,
                                       rock.density});
  }
  for (const auto& [i, j] : {std::pair{0, 1}, std::pair{1, 2}, std::pair{0, 2}})
    rock_of_three.bonds.push_back({i, j, 2 * radius, radius / 2, 1});
  rock_of_three.colour_begin = {0, 1, 2, 3};
  return rock_of_three;
}

/// A belt accelerates a ball to 2/7 of its speed and a block to its full speed.
void belt(Recorder& out) {
  const double mu = 0.5, belt = 1, dt = 1e-5;
  Scene scene = scene_of(rock, rigid(), {mu, 0.5, 0}, dt);
  scene.gravity = {0, 0, -g};
  scene.bonds = BondParameters{2e9, 1e9, 1e9, 1e9, 0.05};
  scene.walls = {floor_mesh(3)};
  scene.walls[0].motion = LinearMotion{{belt, 0, 0}};
  Stage stage(scene, out.precision());
  const double z = radius - static_overlap(youngs_against_rigid(rock), radius, sphere_mass(radius, rock.density) * g);
  stage.insert({sledge(0, {0, 0.3, z}), sphere(3, {0, -0.3, z}, {0, 0, 0}, radius, rock.density)});
  double rolls_at = 0, comes_at = 0;
  while (stage.time() < 0.25) {
    stage.advance(10);
    const ParticleSnapshot s = stage.dem().particles();
    const double patch = s.velocity[3].x - radius * s.angular_velocity[3].y;
    if (rolls_at == 0 && patch > belt * (1 - 1e-3)) rolls_at = stage.time();
    if (comes_at == 0 && s.velocity[0].x > belt * (1 - 1e-3)) comes_at = stage.time();
  }
  const ParticleSnapshot s = stage.dem().particles();
  const double block_speed = (s.velocity[0].x + s.velocity[1].x + s.velocity[2].x) / 3;
  out.relative("ball-rolls-after", rolls_at, 2 * belt / (7 * mu * g), {5e-3, 5e-3}, "2 V/(7 mu g)");
  out.relative("ball-velocity", s.velocity[3].x, 2.0 / 7 * belt, {5e-3, 5e-3}, "2 V/7");
  out.relative("block-comes-along-after", comes_at, belt / (mu * g), {5e-3, 5e-3}, "V/(mu g)");
  out.relative("block-velocity", block_speed, belt, {1e-4, 1e-4}, "V");
}

/// In each step the tangential spring of a held sphere grows with the velocity of the disc below it.
void disc_under_a_held_sphere(Recorder& out) {
  const double angular_velocity = 10, deep = 1e-4, dt = 1e-7;
  const Vec3d axis{0, 0, 1}, point{0.1, 0.2, 0}, foot{0.35, -0.1, 0};
  Scene scene = scene_of(rock, rigid(), {10, 1, 0}, dt);
  scene.walls = {floor_mesh(3)};
  scene.walls[0].motion = RotationMotion{axis, point, angular_velocity};
  Stage stage(scene, out.precision());
  stage.insert({held_sphere(0, foot + Vec3d{0, 0, radius - deep}, radius)});
  stage.advance(1);
  const Vec3d before = stage.dem().particles().force[0];
  stage.advance(1);
  const double stiffness = 8 * rock.shear_modulus / (2 - rock.poisson_ratio) * std::sqrt(radius * deep);
  const Vec3d got = 1 / (stiffness * dt) * (stage.dem().particles().force[0] - before);
  const Vec3d expected = cross(angular_velocity * axis, foot - point);
  out.absolute("velocity-of-contact", norm(Vec3d{got.x, got.y, 0} - expected) / norm(expected), 0, {1e-10, 1e-5},
               "omega x r, from the change of the tangential force");
}

/// A ball that rolls on a turntable moves in a circle at 2/7 of the table's angular velocity.
void ball_on_a_turntable(Recorder& out) {
  const double angular_velocity = 10, v = 0.2, dt = 1e-5, orbit = 2 * angular_velocity / 7, period = 2 * pi / orbit;
  Scene scene = scene_of(rock, rigid(), {0.8, 0.5, 0}, dt);
  scene.gravity = {0, 0, -g};
  scene.walls = {floor_mesh(3)};
  scene.walls[0].motion = RotationMotion{{0, 0, 1}, {0, 0, 0}, angular_velocity};
  Stage stage(scene, out.precision());
  const double z = radius - static_overlap(youngs_against_rigid(rock), radius, sphere_mass(radius, rock.density) * g);
  // There is no slip at the start: v + w x (-R z) = W x r, with the angular velocity W of the table.
  const Vec3d start{0.1, 0, z}, velocity{0, v, 0}, under{0, angular_velocity * start.x, 0};
  const Vec3d slip = under - velocity;
  stage.insert({sphere(0, start, velocity, radius, rock.density, {slip.y / radius, -slip.x / radius, 0})});
  const double quarter = std::round(period / 4 / dt);
  stage.advance(static_cast<int>(quarter));
  const double angle = orbit * quarter * dt;
  const ParticleSnapshot s = stage.dem().particles();
  const Vec3d expected{start.x - v / orbit * (1 - std::cos(angle)), v / orbit * std::sin(angle), z};
  out.absolute("position", norm(s.position[0] - expected) * orbit / v, 0, {2e-3, 2e-3},
               "circle of radius 7 v/(2 omega) at 2/7 omega (rolling ball)");
  out.relative("speed", norm(s.velocity[0]), v, {2e-3, 2e-3}, "constant");
}

/// The momentum and angular momentum that the spheres gain are opposite to the impulses on the walls: moving planes,
/// profiles and meshes, with friction and rolling resistance. The spheres start and end in free flight.
void action_and_reaction(Recorder& out) {
  const double big = 0.5, dt = 2e-6;
  const ProfileShape ring{{{4, -3}, {4, 3}}};
  Scene scene = scene_of({"rock", 2600, 20e9, 0.25}, rigid(), {0.4, 0.6, 0.02}, dt);
  scene.walls = {{"plane", PlaneShape{{0, 0, -2}, {0, 0, 1}}, LinearMotion{{0.3, 0.1, 0.2}}, 1},
                 {"ring", ring, RotationMotion{{0, 0, 1}, {0, 0, 0}, 0.7}, 1},
                 {"mesh", split_square(3, 40), CircularMotion{0.01, 0.5}, 1}};
  for (Vec3d& v : std::get<TriangleMesh>(scene.walls[2].shape).vertices) v.z += 2 + 0.05 * v.x;
  Stage stage(scene, out.precision());
  for (int k = 0; k < 6; ++k) {
    const double angle = k * pi / 3;
    const Vec3d along{std::cos(angle), std::sin(angle), 0};
    const Vec3d v = k % 3 == 0 ? 9.0 * along : Vec3d{2 * along.x, 2 * along.y, k % 3 == 1 ? -9.0 : 9.0};
    stage.insert({sphere(static_cast<ParticleId>(k), 2.2 * along, v, big, 2600, {3.0 * k, 10, -4.0 + k})});
  }
  const Vec3d p0 = stage.dem().momentum(), l0 = angular_momentum(stage.dem().particles());
  Vec3d impulse[3]{}, torque[3]{};
  double exchanged = 0;  // [N s]
  for (int k = 0; k < 1250; ++k) {
    const double before = stage.time();
    stage.advance(100);
    for (std::size_t w = 0; w < 3; ++w) {
      const WallLoad load = stage.dem().wall_loads()[w];
      impulse[w] += (stage.time() - before) * load.force;
      torque[w] += (stage.time() - before) * load.torque;
      exchanged += (stage.time() - before) * norm(load.force);
    }
  }
  const ParticleSnapshot s = stage.dem().particles();
  double pushing = 0;
  for (std::size_t w = 0; w < 3; ++w) pushing += norm(stage.dem().wall_loads()[w].force);
  const Vec3d gained = stage.dem().momentum() - p0, gained_angular = angular_momentum(s) - l0;
  double minimum = norm(impulse[0]);
  for (const Vec3d& i : impulse) minimum = std::min(minimum, norm(i));
  out.within("smallest-impulse-of-a-wall-over-all", minimum / exchanged, 1e-3, 1, "every wall is hit");
  out.absolute("free-at-the-end", pushing, 0, {0, 0}, "no contact at the end");
  out.absolute("momentum", norm(gained + impulse[0] + impulse[1] + impulse[2]) / exchanged, 0, {1e-12, 1e-12},
               "action and reaction");
  out.absolute("angular-momentum", norm(gained_angular + torque[0] + torque[1] + torque[2]) / (4 * exchanged), 0,
               {1e-12, 1e-5}, "action and reaction");
}

/// A mantle that gyrates a million times returns to its initial position.
void million_gyrations(Recorder& out) {
  const GyrationMotion motion{0.0217, 4.2, 0.05};
  const double tilt = std::asin(motion.eccentricity / motion.pivot_height), speed = 16.8, dt = 1e-6;
  const ProfileShape mantle{{{0.5, 1.5}, {0.9, 0}}};
  Scene scene = scene_of(rock, rigid(), {0, 1, 0}, dt);
  scene.walls = {{"mantle", revolve(mantle, 64), motion, 1}};
  Stage stage(scene, out.precision());
  const double out_of_axis = std::sqrt(0.5), z = 0.7, r = 0.9 - 0.4 * z / 1.5 + 0.045;
  stage.insert({held_sphere(0, {r * out_of_axis, r * out_of_axis, z}, 0.05)});
  // The spin cancels the rotation by the conical motion of the axis, so that each gyration ends where it began.
  const auto path = [&](double cycles) {
    const double angle = 2 * pi * cycles;
    return MantlePath{angle, speed, -angle * (1 - std::cos(tilt)), -speed * (1 - std::cos(tilt))};
  };
  const auto force_and_pose = [&](double cycles) {
    stage.advance(1, path(cycles));
    return std::pair{stage.dem().particles().force[0], stage.dem().wall_poses()[0]};
  };
  const auto [force0, pose0] = force_and_pose(0);
  const auto [force1, pose1] = force_and_pose(1e6);
  const auto [force2, pose2] = force_and_pose(1e6 + 0.5);
  double moved = 0, half_way = 0;
  for (const Vec3d& v : std::get<TriangleMesh>(scene.walls[0].shape).vertices) {
    moved = std::max(moved, norm(to_world(pose1, v) - to_world(pose0, v)));
    half_way = std::max(half_way, norm(to_world(pose2, v) - to_world(pose0, v)));
  }
  out.absolute("vertices", moved, 0, {1e-9, 1e-9}, "returns to its position [m]");
  out.relative("half-a-gyration", half_way, 2 * motion.eccentricity, {0.05, 0.05}, "the throw, at the lowest level");
  out.relative("force-on-a-held-sphere", norm(force1), norm(force0), {1e-6, 1e-5}, "returns to its position");
}

}  // namespace

std::vector<Verification> mesh_motion_cases() {
  return {
      {"mesh/m6-belt", belt},
      {"mesh/m7-disc-under-a-held-sphere", disc_under_a_held_sphere},
      {"mesh/m7-ball-on-a-turntable", ball_on_a_turntable},
      {"mesh/m8-action-and-reaction", action_and_reaction},
      {"mesh/m9-million-gyrations", million_gyrations},
  };
}

}  // namespace gyro::verify
