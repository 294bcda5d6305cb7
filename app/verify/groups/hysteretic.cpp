// SPDX-License-Identifier: GPL-3.0-or-later
// The hysteretic normal force: an impact is a quarter oscillation on the loading spring, followed by one on the
// unloading spring.
#include "app/verify/fixtures/held_sphere.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/impact.hpp"
#include "app/verify/fixtures/rig.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

const std::string walton_braun = "Walton & Braun (1986): k1 d while loading, k1/e^2 while unloading";
const Material stone = elastic(48e9, 0.20, 2800);
constexpr double radius = 0.01;
constexpr double fine = 500;  ///< steps per quarter oscillation of the loading spring

PairProperties hysteretic(double restitution, double friction = 0) {
  return {friction, restitution, 0, {NormalModel::hysteretic, RollingModel::constant}};
}

/// Loading stiffness k1 [N/m]: the slope of the straight line from the origin to Hertz's force at an overlap of R*/10.
/// @param youngs  E* [Pa]  @param contact_radius  R* [m]
double loading_stiffness(double youngs, double contact_radius) {
  const double overlap = 0.1 * contact_radius;
  return 4.0 / 3 * youngs * std::sqrt(contact_radius * overlap);
}

/// Two bodies of reduced mass m that meet at a speed v.
struct HystereticImpact {
  double overlap;   ///< v sqrt(m/k1) [m]
  double pressed;   ///< time until the force is zero: pi/2 sqrt(m/k1) (1 + e) [s]
  double duration;  ///< time until the bodies separate: `pressed` and the time in which they cover (1 - e^2) overlap at
                    ///< e v [s]
  double lost;      ///< energy lost: m v^2/2 (1 - e^2) [J]

  HystereticImpact(double stiffness, double mass, double speed, double e) {
    const double time = std::sqrt(mass / stiffness);
    overlap = speed * time;
    pressed = 0.5 * pi * time * (1 + e);
    duration = pressed + time * (1 - e * e) / e;
    lost = 0.5 * mass * speed * speed * (1 - e * e);
  }
};

/// Measured values of an impact, divided by those of theory; the rebound is divided by the speed of approach.
struct Ratios {
  double rebound, overlap, pressed, duration, lost;
};

Ratios ratios(Stage& stage, const ImpactResult& got, const HystereticImpact& theory, double rebound) {
  return {rebound, got.overlap / theory.overlap, got.pressed / theory.pressed, got.duration / theory.duration,
          stage.dem().energy().contact_damping / theory.lost};
}

/// @param steps  per quarter oscillation of the loading spring, which ends at the largest overlap
Ratios spheres_meet(double e, double speed, double steps, Precision precision) {
  const double mass = 0.5 * sphere_mass(radius, stone.density);
  const double k1 = loading_stiffness(youngs_of_pair(stone), 0.5 * radius);
  const HystereticImpact theory(k1, mass, 2 * speed, e);
  Stage stage(scene_of(stone, rigid(), hysteretic(e), 0.5 * pi * std::sqrt(mass / k1) / steps), precision);
  stage.insert(head_on(stone, radius, speed));
  const auto overlap = [](const ParticleSnapshot& s) { return 2 * radius - norm(s.position[1] - s.position[0]); };
  const ImpactResult got = watch_impact(stage, overlap, 2 * theory.duration);
  return ratios(stage, got, theory, -got.velocity.x / speed);
}

Ratios sphere_hits(const Wall& wall, double e, double speed, double steps, Precision precision) {
  const double mass = sphere_mass(radius, stone.density);
  const double k1 = loading_stiffness(youngs_against_rigid(stone), radius);
  const HystereticImpact theory(k1, mass, speed, e);
  Scene scene = scene_of(stone, rigid(), hysteretic(e), 0.5 * pi * std::sqrt(mass / k1) / steps);
  scene.walls = {wall};
  Stage stage(scene, precision);
  stage.insert({sphere(0, {0, 0, radius}, {0, 0, -speed}, radius, stone.density)});
  const auto overlap = [](const ParticleSnapshot& s) { return radius - s.position[0].z; };
  const ImpactResult got = watch_impact(stage, overlap, 2 * theory.duration);
  return ratios(stage, got, theory, got.velocity.z / speed);
}

/// Impacts with one restitution at three speeds. The relative error of velocity Verlet is the square of step times
/// frequency, here the frequency of the unloading spring. At the lowest speed the overlap is 7e-8 m; the rounding of
/// positions then changes the restitution by 1e-10, and in single precision the rounding error divided by e^2 is added.
template <class Impact>
void at_three_speeds(Recorder& out, double e, const Impact& impact) {
  char name[16];
  std::snprintf(name, sizeof name, "e-%03.0f", 100 * e);
  const std::string prefix = name;
  const Ratios slow = impact(e, 0.01), middle = impact(e, 1), fast = impact(e, 10);
  const auto spread = std::minmax({slow.rebound, middle.rebound, fast.rebound});
  const double error = std::pow(0.5 * pi / fine / e, 2);
  out.relative(prefix + "-rebound", middle.rebound, e, {error, error}, "e = sqrt(k1/k2)");
  out.absolute(prefix + "-at-all-speeds", spread.second - spread.first, 0, {1e-9, 5e-6},
               "the law has no scale of speed");
  out.relative(prefix + "-overlap", middle.overlap, 1, {1e-5, 1e-5}, walton_braun);
  out.relative(prefix + "-duration-of-the-force", middle.pressed, 1, {error, error}, walton_braun);
  out.relative(prefix + "-duration-of-the-overlap", middle.duration, 1, {error, error}, walton_braun);
  out.relative(prefix + "-energy-lost", middle.lost, 1, {error, error}, "m v^2/2 (1 - e^2)");
}

void two_spheres(Recorder& out) {
  for (const double e : {0.2, 0.5, 0.9})
    at_three_speeds(out, e, [&](double r, double speed) { return spheres_meet(r, speed, fine, out.precision()); });
}

void on_wall(Recorder& out) {
  const auto on = [&](const Wall& wall, double e, double speed) {
    return sphere_hits(wall, e, speed, fine, out.precision());
  };
  for (const double e : {0.2, 0.5, 0.9})
    at_three_speeds(out, e, [&](double r, double speed) { return on(floor_plane(), r, speed); });
  out.relative("rebound-from-triangles", on(floor_mesh(1), 0.5, 1).rebound, on(floor_plane(), 0.5, 1).rebound,
               {1e-12, 1e-12}, "the same impact on a plane");
}

/// In both runs the largest overlap and the end of the force are reached at the end of a step.
void converges(Recorder& out) {
  const Ratios coarse = spheres_meet(0.5, 1, 20, out.precision()), half = spheres_meet(0.5, 1, 40, out.precision());
  const std::string order = "second order of velocity Verlet";
  out.within("error-of-rebound-by-half-a-step", (coarse.rebound - 0.5) / (half.rebound - 0.5), 3.5, 4.5, order);
  out.within("error-of-overlap-by-half-a-step", (coarse.overlap - 1) / (half.overlap - 1), 3.5, 4.5, order);
}

/// A held sphere is pressed, unloaded, and pressed again to a larger overlap.
void pressed_by_hand(Recorder& out) {
  const double e = 0.5, deep = 1e-5, residual = (1 - e * e) * deep;
  const double k1 = loading_stiffness(youngs_against_rigid(stone), radius), k2 = k1 / (e * e);
  Rig rig(stone, hysteretic(e), 1e-6, held_sphere(0, Rig::contact + Vec3d{radius, 0, 0}, radius), out.precision());
  const auto force = [&](const std::string& name, double expected) {
    out.absolute(name, rig.force().x / (k1 * deep), expected / (k1 * deep), {1e-6, 1e-5}, walton_braun);
  };
  rig.move(deep, 0, 40000);
  force("loaded", k1 * deep);
  rig.move(-0.1 * deep, 0, 40000);
  force("unloaded-by-a-tenth", k1 * deep - k2 * 0.1 * deep);
  rig.move(0.9 * residual - 0.9 * deep, 0, 40000);
  force("below-the-residual-overlap", 0);
  out.relative("work-lost", rig.work(), 0.5 * k1 * deep * deep * (1 - e * e), {5e-5, 5e-5},
               "triangle between the springs, to within two steps of 40,000");
  rig.move(0.1 * deep + residual - 0.9 * residual, 0, 4000);
  force("reloaded", k2 * 0.1 * deep);
  rig.move(1.4 * deep - residual, 0, 4000);
  force("loaded-further", 1.5 * k1 * deep);
}

/// A held sphere is pressed and sheared: the tangential stiffness is Mindlin's share of the loading stiffness at any
/// overlap.
void sheared_by_hand(Recorder& out) {
  const double deep = 1e-5, shear = 1e-6;
  const double share = 2 * (1 - stone.poisson_ratio) / (2 - stone.poisson_ratio);  // 4 G*/E* on a rigid wall
  const double tangential = share * loading_stiffness(youngs_against_rigid(stone), radius);
  for (const double press : {deep, 4 * deep}) {
    Rig rig(stone, hysteretic(0.5, 10), 1e-6, held_sphere(0, Rig::contact + Vec3d{radius, 0, 0}, radius),
            out.precision());
    rig.move(press, 0, 4000);
    const double start = rig.force().y;
    rig.move(0, shear, 4000);
    out.relative(press == deep ? "stiffness" : "stiffness-four-times-as-deep", (rig.force().y - start) / shear,
                 tangential, {1e-5, 1e-4}, "Mindlin: St/Sn = 4 G*/E*");
  }
}

/// A sphere slides while it rebounds: the impulse of friction is mu times that of the normal force.
void slides(Recorder& out) {
  const double e = 0.4, mu = 0.1, fall = 1, slide = 5;
  const double mass = sphere_mass(radius, stone.density);
  const double k1 = loading_stiffness(youngs_against_rigid(stone), radius);
  const HystereticImpact theory(k1, mass, fall, e);
  Scene scene = scene_of(stone, rigid(), hysteretic(e, mu), 0.5 * pi * std::sqrt(mass / k1) / fine);
  scene.walls = {floor_plane()};
  Stage stage(scene, out.precision());
  stage.insert({sphere(0, {0, 0, radius}, {slide, 0, -fall}, radius, stone.density)});
  const auto overlap = [](const ParticleSnapshot& s) { return radius - s.position[0].z; };
  const ImpactResult got = watch_impact(stage, overlap, 2 * theory.duration);
  const double lever = 1 - theory.overlap / radius;  // smallest; the mean lever lies between this and 1
  out.relative("velocity-lost", slide - got.velocity.x, mu * (1 + e) * fall, {1e-4, 1e-4}, "mu x impulse");
  out.within("spin", got.angular_velocity.y * radius / (2.5 * mu * (1 + e) * fall), lever, 1, "lever of friction");
  out.absolute("energy-residual", stage.dem().energy().residual() / theory.lost, 0, {1e-6, 1e-6}, "first law");
}

}  // namespace

std::vector<Verification> hysteretic_cases() {
  return {
      {"hysteretic/two-spheres", two_spheres},         {"hysteretic/on-wall", on_wall},
      {"hysteretic/convergence", converges},           {"hysteretic/pressed-by-hand", pressed_by_hand},
      {"hysteretic/sheared-by-hand", sheared_by_hand}, {"hysteretic/sliding", slides},
  };
}

}  // namespace gyro::verify
