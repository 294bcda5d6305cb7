// SPDX-License-Identifier: GPL-3.0-or-later
// Edges, seams and corners of meshes (M3 to M5).
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

constexpr double radius = 0.01;
const Material rock = soft_rock();

/// A stair: floor z = 0 for x < 0, riser x = 0 from z = 0 to 0.2, top z = 0.2 for x > 0 [m].
Wall stair() {
  return {"stair",
          TriangleMesh{
              {{-1, -1, 0}, {0, -1, 0}, {0, 1, 0}, {-1, 1, 0}, {0, -1, 0.2}, {0, 1, 0.2}, {1, -1, 0.2}, {1, 1, 0.2}},
              {{0, 1, 2}, {0, 2, 3}, {1, 4, 5}, {1, 5, 2}, {4, 6, 7}, {4, 7, 5}}},
          Fixed{}, 1};
}

Wall fold(double degrees) {
  return {"fold", folded(degrees, 1), Fixed{}, 1};
}

/// A held sphere passes the upper edge of the stair; it touches first the top, then the edge, then the riser.
void over_a_convex_edge(Recorder& out) {
  const double k = 0.94 * radius, path = 1.08 * radius;  // it passes the edge at a distance of k/sqrt(2)
  const int steps = 2000;
  Scene scene = scene_of(rock, rigid(), {0, 1, 0}, 1e-6);
  scene.walls = {stair()};
  Stage stage(scene, out.precision());
  const Vec3d start{radius - k, 0.1, 0.2 + radius}, step = (path / steps) * Vec3d{-1, 0.3, -1};
  stage.insert({held_sphere(0, start, radius, 1 / scene.dt * step)});
  double worst = 0, largest_step = 0;
  Vec3d last{0, 0, 0};
  for (int n = 1; n <= steps; ++n) {
    stage.advance(1);
    const ParticleSnapshot s = stage.dem().particles();
    // From the nearest point of the quarter space x > 0, z < 0.2.
    const Vec3d x = s.position[0];
    const Vec3d from{x.x < 0 ? x.x : 0, 0, x.z > 0.2 ? x.z - 0.2 : 0};
    const double deep = radius - norm(from);
    const Vec3d expected = deep > 0 ? hertz_force(rock, radius, deep) / norm(from) * from : Vec3d{0, 0, 0};
    worst = std::max(worst, norm(s.force[0] - expected));
    if (n > 1) largest_step = std::max(largest_step, norm(s.force[0] - last));
    last = s.force[0];
  }
  const double peak = hertz_force(rock, radius, radius - k / std::sqrt(2.0));
  out.absolute("force", worst / peak, 0, {1e-9, 1e-6}, "Hertz at the nearest point of a quarter space");
  out.within("largest-change-x-steps", largest_step / peak * steps, 0, 10, "continuous: no jump in a step");
}

/// A frictionless sphere moves slowly over the edge and falls: the edge does no work on it.
void rolls_over_a_convex_edge(Recorder& out) {
  Scene scene = scene_of(rock, rigid(), {0, 1, 0}, 2e-6);
  scene.gravity = {0, 0, -9.81};
  scene.walls = {stair()};
  Stage stage(scene, out.precision());
  const double mass = sphere_mass(radius, rock.density);
  const double deep = static_overlap(youngs_against_rigid(rock), radius, mass * 9.81);
  stage.insert({sphere(0, {0.002, 0, 0.2 + radius - deep}, {-0.1, 0.03, 0}, radius, rock.density)});
  double worst = 0;
  for (int k = 0; k < 500; ++k) {
    stage.advance(100);
    worst = std::max(worst, std::abs(stage.dem().energy().residual()));
  }
  const ParticleSnapshot s = stage.dem().particles();
  out.absolute("has-left", s.position[0].x < -0.003 && s.position[0].z < 0.2 ? 1 : 0, 1, {0, 0},
               "it has fallen past the edge");
  out.absolute("energy", worst / (mass * 9.81 * radius), 0, {1e-5, 1e-5}, "conserved, over m g R");
}

/// In a right-angled corner each face is a full contact.
void corners(Recorder& out) {
  const double a = 0.02 * radius, b = 0.03 * radius, c = 0.01 * radius;
  const Vec3d two = force_on_held({stair()}, rock, radius, {a - radius, 0.1, radius - b}, out.precision());
  out.relative("two-faces-riser", -two.x, hertz_force(rock, radius, a), {1e-9, 1e-6}, "Hertz on each face");
  out.relative("two-faces-floor", two.z, hertz_force(rock, radius, b), {1e-9, 1e-6}, "Hertz on each face");
  const Wall box{"box", TriangleMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}},
                 Fixed{}, 1};
  const Vec3d three = force_on_held({box}, rock, radius, {radius - a, radius - b, radius - c}, out.precision());
  out.relative("three-faces-x", three.x, hertz_force(rock, radius, a), {1e-9, 1e-6}, "Hertz on each face");
  out.relative("three-faces-y", three.y, hertz_force(rock, radius, b), {1e-9, 1e-6}, "Hertz on each face");
  out.relative("three-faces-z", three.z, hertz_force(rock, radius, c), {1e-9, 1e-6}, "Hertz on each face");
}

/// A sphere above a seam overlaps both faces by `deep`. @return relative deviation of its force from that on a plane
double seam_error(double degrees, Precision precision) {
  const double deep = 0.01 * radius, half = (180 - degrees) / 2 * pi / 180;
  const Vec3d force =
      force_on_held({fold(degrees)}, rock, radius, {0, 0.1, (radius - deep) / std::cos(half)}, precision);
  return norm(force - Vec3d{0, 0, hertz_force(rock, radius, deep)}) / hertz_force(rock, radius, deep);
}

/// In the limit of a flat fold a seam acts like a plane.
void flat_seams(Recorder& out) {
  for (const double degrees : {178.0, 179.0, 179.9}) {
    const double bend = (180 - degrees) * pi / 180;
    out.absolute("error-at-" + std::to_string(std::lround(10 * degrees)) + "-tenths",
                 seam_error(degrees, out.precision()), 0, {bend * bend, bend * bend},
                 "a plane, to the second order of the fold");
  }
}

/// A held sphere crosses a fold in a number of steps. @return the largest change of its force in one step, divided by
/// the force on a plane
double largest_change(double degrees, int steps, Precision precision) {
  const double deep = 0.01 * radius, half = std::abs(180 - degrees) / 2 * pi / 180;
  const bool valley = degrees < 180;
  const double height = valley ? (radius - deep) / std::cos(half) : radius - deep;
  const double width = 1.3 * std::max(height * std::sin(half), 0.02 * radius);
  Scene scene = scene_of(rock, rigid(), {0, 1, 0}, 1e-6);
  scene.walls = {fold(degrees)};
  Stage stage(scene, precision);
  stage.insert({held_sphere(0, {-width, 0.1, height}, radius, {2 * width / (steps * scene.dt), 0, 0})});
  stage.advance(1);
  double largest = 0;
  Vec3d last = stage.dem().particles().force[0];
  for (int k = 1; k < steps; ++k) {
    stage.advance(1);
    const Vec3d now = stage.dem().particles().force[0];
    largest = std::max(largest, norm(now - last));
    last = now;
  }
  return largest / hertz_force(rock, radius, deep);
}

/// The force is continuous: its largest change falls with the step, while a jump would not.
void no_jumps(Recorder& out) {
  const double folds[] = {90, 119, 121, 150, 175, 179, 179.9, 190, 240, 270};
  for (const double degrees : folds) {
    const std::string name = "fold-of-" + std::to_string(std::lround(10 * degrees)) + "-tenths";
    const double ratio =
        largest_change(degrees, 10000, out.precision()) / largest_change(degrees, 1000, out.precision());
    out.within(name, ratio, 0, 0.16, "continuous: a tenth of the step, a tenth of the largest change");
  }
}

/// A held sphere crosses a valley without slip, by the length `path` on each face. The first face is unloaded, then the
/// second is loaded, and the friction of the first is carried over: F = S(0) path + the integral of S over the second
/// face, with S(x) = 8 G* sqrt(R d).
void friction_across_a_valley(Recorder& out) {
  const double degrees = 179, half = 0.5 * pi / 180, deep = 0.01 * radius, path = 0.026 * radius;
  const double height = (radius - deep) / std::cos(half);
  const int steps = 2000;
  Scene scene = scene_of(rock, rigid(), {100, 1, 0}, 1e-6);
  scene.walls = {fold(degrees)};
  Stage stage(scene, out.precision());
  stage.insert({held_sphere(0, {-path, 0.1, height}, radius, {2 * path / (steps * scene.dt), 0, 0})});
  stage.advance(steps);

  const double shear = rock.shear_modulus / (2 - rock.poisson_ratio);  // G* against a rigid wall
  const auto stiffness = [&](double x) {
    const double overlap = radius - (height * std::cos(half) - std::abs(x) * std::sin(half));
    return 8 * shear * std::sqrt(radius * overlap);
  };
  double expected = stiffness(0) * path;
  for (int k = 0; k < steps; ++k) expected += stiffness((k + 0.5) / steps * path) * path / steps;
  const double force = -dot(stage.dem().particles().force[0], Vec3d{std::cos(half), 0, std::sin(half)});
  out.relative("force-on-the-second-face", force, std::cos(half) * expected, {2e-3, 2e-3},
               "Mindlin without slip, over both faces");
}

/// The force from the tip of a pyramid points away from the tip.
void tip(Recorder& out) {
  const Wall pyramid{"pyramid",
                     TriangleMesh{{{0, 0, 0}, {1, 0, -1}, {0, 1, -1}, {-1, 0, -1}, {0, -1, -1}},
                                  {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}}},
                     Fixed{}, 1};
  const Vec3d centre{0.1 * radius, 0.2 * radius, 0.95 * radius};
  const Vec3d force = force_on_held({pyramid}, rock, radius, centre, out.precision());
  const double expected = hertz_force(rock, radius, radius - norm(centre));
  out.relative("force", norm(force), expected, {1e-9, 1e-6}, "Hertz: one contact");
  out.absolute("direction", norm(1 / norm(force) * force - 1 / norm(centre) * centre), 0, {1e-12, 1e-6},
               "from the tip");
}

}  // namespace

std::vector<Verification> mesh_edges_cases() {
  return {
      {"mesh/m3-over-a-convex-edge", over_a_convex_edge},
      {"mesh/m3-falls-over-a-convex-edge", rolls_over_a_convex_edge},
      {"mesh/m4-corners", corners},
      {"mesh/m4-flat-seams", flat_seams},
      {"mesh/m4-no-jumps", no_jumps},
      {"mesh/m4-friction-across-a-valley", friction_across_a_valley},
      {"mesh/m5-tip", tip},
  };
}

}  // namespace gyro::verify
