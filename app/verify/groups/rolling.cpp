// SPDX-License-Identifier: GPL-3.0-or-later
// Rolling resistance by a constant torque: closed forms of rigid-body mechanics for a ball with I = 2/5 m R^2.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/impact.hpp"
#include "app/verify/fixtures/on_floor.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::verify {
namespace {

using namespace fixtures;

constexpr double g = OnFloor::g, radius = OnFloor::radius;
const std::string source = "rigid-body mechanics of a ball, torque mu_r R Fn";

/// A ball rolls to a stop on a flat floor and then stays at rest.
void flat(Recorder& out) {
  const double mu_r = 0.05, v = 1;
  OnFloor s({{0.5, 0.5, mu_r}, 0, v, v / radius}, out.precision());
  s.run_to(1);
  out.relative("deceleration", v - s.speed(), 5.0 / 7 * mu_r * g, {2e-3, 2e-3}, source);
  out.relative("spin", s.angular_velocity() * radius, s.speed(), {1e-4, 1e-4}, "rolls without slip");
  s.run_to(3);
  out.relative("distance", s.x(), 7 * v * v / (10 * mu_r * g), {2e-3, 2e-3}, source);
  out.absolute("rest", s.run_to(4), 0, {1e-9 * radius, 1e-9}, "at rest for 1 s, R w and v at each 50th step");
}

/// A ball spins on a floor without friction and does not move.
void smooth_floor(Recorder& out) {
  const double mu_r = 0.02, angular_velocity = 50;
  OnFloor s({{0, 0.5, mu_r}, 0, 0, angular_velocity}, out.precision());
  s.run_to(0.5);
  out.relative("spin-lost", angular_velocity - s.angular_velocity(), 2.5 * mu_r * g / radius * 0.5, {1e-3, 1e-3},
               source);
  out.absolute("velocity", s.speed(), 0, {1e-15, 1e-15}, "no friction");
}

void down_a_slope(Recorder& out) {
  const double slope = 0.1, mu_r = 0.04;
  OnFloor s({{0.5, 0.5, mu_r}, slope, 0, 0}, out.precision());
  s.run_to(0.05);
  const double before = s.speed();
  s.run_to(0.45);
  out.relative("acceleration", (s.speed() - before) / 0.4, 5.0 / 7 * g * (std::sin(slope) - mu_r * std::cos(slope)),
               {2e-3, 2e-3}, source);
}

/// A coefficient above the tangent of the slope holds the ball; with a coefficient below it the ball rolls.
void held_on_a_slope(Recorder& out) {
  const double slope = 0.1;
  OnFloor held({{0.5, 0.5, 1.02 * std::tan(slope)}, slope, 0, 0}, out.precision());
  held.run_to(0.5);
  const double position = held.x();
  out.absolute("rest", held.run_to(1.5), 0, {1e-9 * radius, 1e-9}, "at rest for 1 s, R w and v");
  out.absolute("creep", held.x() - position, 0, {1e-9 * radius, 1e-9}, "at rest for 1 s");
  const double less = 0.9 * std::tan(slope);
  OnFloor rolls({{0.5, 0.5, less}, slope, 0, 0}, out.precision());
  rolls.run_to(0.5);
  out.relative("speed-below-the-limit", rolls.speed(), 0.5 * 5.0 / 7 * g * 0.1 * std::sin(slope), {5e-3, 5e-3}, source);
}

/// A ball lies in a groove of two walls that runs downhill. Both contacts contribute to the rolling resistance;
/// together they must not push the ball uphill.
void held_in_a_groove(Recorder& out) {
  const double slope = 0.05, half = 1 / std::sqrt(2.0);
  Scene scene = scene_of(soft_rock(), rigid(), {0.5, 0.5, 0.2}, OnFloor::dt);
  scene.gravity = {g * std::sin(slope), 0, -g * std::cos(slope)};
  scene.walls = {{"left", PlaneShape{{0, 0, 0}, {0, half, half}}, Fixed{}, 1},
                 {"right", PlaneShape{{0, 0, 0}, {0, -half, half}}, Fixed{}, 1}};
  Stage stage(scene, out.precision());
  const double force = sphere_mass(radius, rock_density) * g * std::cos(slope) * half;
  const double deep = static_overlap(youngs_against_rigid(soft_rock()), radius, force);
  stage.insert({sphere(0, {0, 0, (radius - deep) / half}, {0, 0, 0}, radius, rock_density, {0, 3, 0})});
  stage.advance(100000);
  double fastest = 0;
  for (int k = 0; k < 2000; ++k) {
    stage.advance(7);
    const ParticleSnapshot s = stage.dem().particles();
    fastest = std::max({fastest, norm(s.velocity[0]), radius * norm(s.angular_velocity[0])});
  }
  out.absolute("rest", fastest, 0, {1e-9 * radius, 1e-9}, "at rest, R w and v at each 7th step");
}

/// Two equal balls with opposite spins roll on each other without slip: the torque mu_r R* Fn acts on both.
void pair(Recorder& out) {
  const double mu_r = 0.01, angular_velocity = 100, fall = 0.2;
  const Material material = elastic(70e9, 0.33, 2700);
  const double mass = sphere_mass(radius, material.density);
  const double dt = head_on_impact(material, radius, fall).duration / 1000;
  Stage stage(scene_of(material, rigid(), {0.4, 1, mu_r}, dt), out.precision());
  stage.insert(head_on(material, radius, fall, angular_velocity, -angular_velocity));
  stage.advance(1100);
  const ParticleSnapshot s = stage.dem().particles();
  // Impulse 2 m v, R* = R/2, I = 2/5 m R^2.
  const double lost = mu_r * (radius / 2) * 2 * mass * fall / (0.4 * mass * radius * radius);
  out.relative("first-spin-lost", angular_velocity - s.angular_velocity[0].z, lost, {1e-3, 1e-3},
               "impulse of the impact x mu_r R*");
  out.relative("second-spin-lost", angular_velocity + s.angular_velocity[1].z, lost, {1e-3, 1e-3},
               "impulse of the impact x mu_r R*");
}

/// A ball without spin hits a wall that rotates about the point of impact: the rolling torque sets the ball rotating.
void rotating_wall(Recorder& out) {
  const double mu_r = 0.01, fall = 2, e = 0.5, spin = 50;
  const Material material = elastic(70e9, 0.33, 2700);
  const ElasticImpact theory = impact_on_wall(material, radius, fall);
  Scene scene = scene_of(material, rigid(), {0, e, mu_r}, theory.duration / 1000);
  scene.walls = {{"wall", PlaneShape{{0, 0, 0}, {0, 0, 1}}, RotationMotion{{0, 1, 0}, {0, 0, 0}, spin}, 1}};
  Stage stage(scene, out.precision());
  stage.insert({sphere(0, {0, 0, radius}, {0, 0, -fall}, radius, material.density)});
  stage.advance(2000);
  out.relative("spin", stage.dem().particles().angular_velocity[0].y, 2.5 * mu_r * (1 + e) * fall / radius,
               {2e-3, 2e-3}, "impulse of the impact x mu_r R");
}

}  // namespace

std::vector<Verification> rolling_cases() {
  return {
      {"rolling/flat", flat},
      {"rolling/smooth-floor", smooth_floor},
      {"rolling/down-a-slope", down_a_slope},
      {"rolling/held-on-a-slope", held_on_a_slope},
      {"rolling/held-in-a-groove", held_in_a_groove},
      {"rolling/pair", pair},
      {"rolling/rotating-wall", rotating_wall},
  };
}

}  // namespace gyro::verify
