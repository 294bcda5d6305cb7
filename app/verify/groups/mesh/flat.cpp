// SPDX-License-Identifier: GPL-3.0-or-later
// A flat mesh acts like a plane, however it is divided into triangles (M1, M2).
#include "app/verify/fixtures/held_sphere.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/meshes.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double radius = 0.01, speed = 2, preload = 100;
constexpr int rays = 8, steps = 50000, every = 50;  // the steps are a path of 1 m
const Material rock = soft_rock();
const std::string plane_run = "the same scene on a plane";

Wall flat(int splits) {
  return {"floor", split_square(1.5, splits), Fixed{}, 1};
}

Vec3d heading(int ray) {
  const double angle = 0.1 + 2 * pi * ray / rays;
  return {std::cos(angle), std::sin(angle), 0};
}

/// Spheres that move from the middle of a floor in eight directions: they roll, or they are held at constant velocity
/// and slide.
std::unique_ptr<Stage> start(const Wall& floor, bool rolling, Precision precision) {
  Scene scene = scene_of(rock, rigid(), {rolling ? 0.3 : 5.0, 0.5, 0}, 1e-5);
  scene.walls = {floor};
  const double deep = static_overlap(youngs_against_rigid(rock), radius, preload);
  // Gravity has a small sideways component, so that friction acts while the spheres roll.
  if (rolling) scene.gravity = {2, 1, -preload / sphere_mass(radius, rock.density)};
  auto stage = std::make_unique<Stage>(scene, precision);
  for (int k = 0; k < rays; ++k) {
    const Vec3d along = heading(k), axis{-along.y, along.x, 0},
                begin = 0.15 * along + Vec3d{0.07, -0.03, radius - deep};
    const auto id = static_cast<ParticleId>(k);
    stage->insert({rolling ? sphere(id, begin, speed * along, radius, rock.density, (speed / radius) * axis)
                           : held_sphere(id, begin, radius, speed * along)});
  }
  return stage;
}

/// Largest differences between two runs, taken at every fiftieth step.
struct Differences {
  double height = 0, path = 0, normal = 0, friction = 0, angular_velocity = 0, energy = 0;

  void add(const ParticleSnapshot& a, const ParticleSnapshot& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
      const Vec3d x = a.position[k] - b.position[k], f = a.force[k] - b.force[k];
      height = std::max(height, std::abs(x.z) / radius);
      path = std::max(path, std::hypot(x.x, x.y) / radius);
      normal = std::max(normal, std::abs(f.z) / preload);
      friction = std::max(friction, std::hypot(f.x, f.y) / preload);
      angular_velocity =
          std::max(angular_velocity, norm(a.angular_velocity[k] - b.angular_velocity[k]) * radius / speed);
    }
  }
};

Differences compare(int splits, bool rolling, Precision precision) {
  const auto mesh = start(flat(splits), rolling, precision), plane = start(floor_plane(), rolling, precision);
  Differences d;
  for (int k = 0; k < steps; k += every) {
    mesh->advance(every);
    plane->advance(every);
    d.add(mesh->dem().particles(), plane->dem().particles());
  }
  const EnergyTerms a = mesh->dem().energy(), b = plane->dem().energy();
  d.energy = (a.kinetic + a.contact_elastic + a.friction) / (b.kinetic + b.contact_elastic + b.friction) - 1;
  return d;
}

void rolls(Recorder& out, int splits) {
  const Differences d = compare(splits, true, out.precision());
  out.absolute("height", d.height, 0, {1e-9, 1e-9}, plane_run + ", over R");
  out.absolute("normal-force", d.normal, 0, {1e-9, 1e-6}, plane_run + ", over the preload");
  out.absolute("friction", d.friction, 0, {1e-9, 1e-6}, plane_run + ", over the preload");
  out.absolute("path", d.path, 0, {1e-9, 1e-6}, plane_run + ", over R");
  out.absolute("spin", d.angular_velocity, 0, {1e-9, 1e-6}, plane_run);
  out.absolute("energy", d.energy, 0, {1e-9, 1e-6}, plane_run);
}

void slides(Recorder& out, int splits) {
  const Differences d = compare(splits, false, out.precision());
  out.absolute("normal-force", d.normal, 0, {1e-9, 1e-6}, plane_run + ", over the preload");
  out.absolute("friction", d.friction, 0, {1e-9, 1e-6}, plane_run + ", over the preload");
}

/// A sphere has exactly one contact with a fan, above a face, an edge and a corner, from both sides.
void fans(Recorder& out) {
  double worst = 0;
  const double deep = 1e-4, expected = hertz_force(rock, radius, deep);
  for (int n = 3; n <= 12; ++n)
    for (const double side : {1.0, -1.0})
      for (const double r : {0.0, 1e-9, 1e-4, 0.02})
        for (const double part : {0.0, 0.3, 0.5}) {
          const double angle = 2 * pi * (1 + part) / n;
          const Vec3d centre{r * std::cos(angle), r * std::sin(angle), side * (radius - deep)};
          const Vec3d force = force_on_held({{"fan", fan(n), Fixed{}, 1}}, rock, radius, centre, out.precision());
          worst = std::max(worst, norm(force - Vec3d{0, 0, side * expected}) / expected);
        }
  out.absolute("largest-error-of-force", worst, 0, {1e-11, 1e-6}, "Hertz: one contact on fans of 3 to 12 triangles");
}

}  // namespace

std::vector<Verification> mesh_flat_cases() {
  return {
      {"mesh/m1-rolls-on-2", [](Recorder& out) { rolls(out, 0); }},
      {"mesh/m1-rolls-on-200", [](Recorder& out) { rolls(out, 99); }},
      {"mesh/m1-rolls-on-20000", [](Recorder& out) { rolls(out, 9999); }},
      {"mesh/m1-slides-on-2", [](Recorder& out) { slides(out, 0); }},
      {"mesh/m1-slides-on-200", [](Recorder& out) { slides(out, 99); }},
      {"mesh/m1-slides-on-20000", [](Recorder& out) { slides(out, 9999); }},
      {"mesh/m2-fans", fans},
  };
}

}  // namespace gyro::verify
