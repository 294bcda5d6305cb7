// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr double gravity = 9.81;
constexpr Index smooth = 2;  ///< frictionless material, for the cylinder that is lifted

/// Spheres of diameters d (1 +- 0.1) on a loose lattice in a cylinder about z, with small random velocities.
/// @param cylinder  its radius [m]
std::vector<NewRock> fill(double d, double cylinder, double height, std::uint64_t seed) {
  std::vector<NewRock> rocks;
  const double step = 1.12 * d;
  const int across = static_cast<int>(cylinder / step), up = static_cast<int>(height / step);
  for (int k = 0; k < up; ++k)
    for (int j = -across; j <= across; ++j)
      for (int i = -across; i <= across; ++i) {
        const Vec3d at{step * i, step * j, step * (k + 0.6)};
        if (std::hypot(at.x, at.y) > cylinder - 0.6 * d) continue;
        const std::uint64_t thing = seed * 1000000 + rocks.size();
        const auto r = [&](std::uint32_t draw) { return random_number(thing, draw); };
        rocks.push_back(sphere(static_cast<ParticleId>(rocks.size()), at, 0.1 * Vec3d{r(0), r(1), r(2)},
                               0.5 * d * (1 + 0.1 * r(3)), rock_density));
      }
  return rocks;
}

/// Grains with a Young's modulus of 2 MPa: at the bottom of 0.1 m of filling Hertz's overlap of six contacts per grain
/// is about 0.015 d.
Scene grains(const PairProperties& pair, double dt) {
  const Material soft = elastic(2e6, 0.3, rock_density);
  Scene scene = scene_of(soft, soft, pair, dt);
  scene.materials.push_back(soft);
  PairProperties slippery = pair;
  slippery.friction = slippery.rolling_friction = 0;
  scene.pairs = {pair, pair, slippery, pair, pair, slippery, slippery, slippery, slippery};
  scene.gravity = {0, 0, -gravity};
  return scene;
}

/// Angle of the heap that remains after the cylinder has been lifted [degrees]. A cone of height h and radius r has the
/// mean height h/4 and the mean radius r/2, so that the tangent is 2 mean height/mean radius.
double heap_angle(const PairProperties& pair, std::uint64_t seed, Precision precision) {
  constexpr double dt = 1.6e-4, d = 0.01, cylinder = 0.045, filling = 0.16, lift = 0.08, duration = 2.4;
  Scene scene = grains(pair, dt);
  scene.walls = {
      {"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1},
      {"cylinder", ProfileShape{{{cylinder, 0}, {cylinder, 2 * filling}}}, LinearMotion{{0, 0, lift}}, smooth}};
  Stage stage(scene, precision);
  stage.insert(fill(d, cylinder, filling, seed));
  stage.advance(static_cast<int>(std::lround(duration / dt)));
  const ParticleSnapshot s = stage.dem().particles();
  double height = 0, radius = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const double r = std::hypot(s.position[k].x, s.position[k].y);
    if (r > 15 * d) continue;  // this sphere has rolled away
    height += s.mass[k] * s.position[k].z;
    radius += s.mass[k] * r;
  }
  return std::atan(2 * height / radius) * 180 / pi;
}

/// Friction of a heap, and the mean angle of five seeds in LAMMPS.
struct Heap {
  const char* name;
  PairProperties pair;
  double lammps;  ///< [degrees], cases/verification/repose/README.md
};

/// Mean angle of five seeds [degrees]. Checks that the seeds agree with each other and their mean with LAMMPS.
double mean_angle(Recorder& out, const Heap& heap) {
  double low = 90, high = 0, sum = 0;
  constexpr int seeds = 5;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const double angle = heap_angle(heap.pair, seed, out.precision());
    low = std::min(low, angle);
    high = std::max(high, angle);
    sum += angle;
  }
  const std::string name = heap.name;
  out.within(name + "-half-range", 0.5 * (high - low), 0, 1.5, "five seeds [degrees]");
  out.absolute(name + "-mean", sum / seeds, heap.lammps, {1.5, 1.5}, "LAMMPS 22Jul2025, the same spheres [degrees]");
  return sum / seeds;
}

/// There is no closed form. The angles are compared with those of LAMMPS, and they must grow with the sliding and with
/// the rolling friction.
void repose(Recorder& out) {
  const double slick = mean_angle(out, {"friction-2-tenths", {0.2, 0.5, 0.1}, 10.64}),
               middle = mean_angle(out, {"friction-5-tenths", {0.5, 0.5, 0.1}, 15.69}),
               rough = mean_angle(out, {"friction-8-tenths", {0.8, 0.5, 0.1}, 17.09}),
               round = mean_angle(out, {"rolling-2-hundredths", {0.5, 0.5, 0.02}, 7.92}),
               edged = mean_angle(out, {"rolling-3-tenths", {0.5, 0.5, 0.3}, 26.58});
  const std::string steeper = "above 0 [degrees]; no closed form";
  out.within("steeper-by-friction-from-2-to-5-tenths", middle - slick, 0, 40, steeper);
  out.within("steeper-by-friction-from-5-to-8-tenths", rough - middle, 0, 40, steeper);
  out.within("steeper-by-rolling-from-2-to-10-hundredths", middle - round, 0, 40, steeper);
  out.within("steeper-by-rolling-from-1-to-3-tenths", edged - middle, 0, 40, steeper);
}

}  // namespace

std::vector<Verification> generic_repose_cases() {
  return {{"generic/repose", repose, Precisions::mixed_only, When::nightly}};
}

}  // namespace gyro::verify
