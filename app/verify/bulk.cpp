// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/verify/bulk.hpp"

#include "app/verify/bonded.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gyro::verify {
namespace {

constexpr double dt = 5e-5, gravity = 9.81, density = 2600;

/// Spheres of diameter d (1 +- 0.1) on a loose lattice in a cylinder, each with a little velocity.
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
                               0.5 * d * (1 + 0.1 * r(3)), density));
      }
  return rocks;
}

/// Rock, walls and a smooth gate of material 2.
Scene grains(const PairProperties& pair) {
  Scene scene = scene_of(elastic(5e6, 0.3, density), elastic(5e6, 0.3, density), pair, dt);
  scene.materials.push_back(elastic(5e6, 0.3, density));
  PairProperties smooth = pair;
  smooth.friction = smooth.rolling_friction = 0;
  scene.pairs = {pair, pair, smooth, pair, pair, smooth, smooth, smooth, smooth};
  scene.gravity = {0, 0, -gravity};
  return scene;
}

struct Outflow {
  double early, late;   ///< mass per time in the two halves of the measurement [kg/s]
  double bulk_density;  ///< of the filled silo [kg/m3]
  double rate() const { return 0.5 * (early + late); }
};

/// A flat-bottomed silo 2.5 D wide, filled to more than 2 D; its gate opens after 0.25 s.
Outflow drain(double d, double orifice, Loads loads) {
  constexpr double settle = 0.25, speed = 2;
  Scene scene = grains({0.5, 0.5, 0});
  const double wall = 1.25 * orifice, height = 3.4 * orifice;
  const double tail = -0.5 * orifice - speed * settle, head = orifice, level = -0.1 * d;
  scene.walls = {
      {"silo", ProfileShape{{{0.5 * orifice, 0}, {wall, 0}, {wall, 2 * height}}}, Fixed{}, 1},
      {"gate",
       MeshShape{{{tail, -orifice, level}, {head, -orifice, level}, {head, orifice, level}, {tail, orifice, level}},
                 {{0, 1, 2}, {0, 2, 3}}},
       LinearMotion{{speed, 0, 0}}, 2}};
  Stage stage(scene, loads);
  stage.insert(fill(d, wall, height, 1));
  const auto until = [&](double time) { stage.advance(static_cast<int>(std::lround((time - stage.time()) / dt))); };
  const auto mass_between = [&](double low, double high) {
    const ParticleSnapshot s = stage.dem().particles();
    double sum = 0;
    for (std::size_t k = 0; k < s.size(); ++k)
      if (s.position[k].z > low && s.position[k].z < high) sum += s.mass[k];
    return sum;
  };
  until(settle);
  Outflow out{};
  out.bulk_density = mass_between(0.5 * orifice, 1.5 * orifice) / (pi * wall * wall * orifice);
  const double begin = settle + orifice / speed + 0.05, span = 0.12;
  std::array<double, 3> out_mass{};
  for (int k = 0; k < 3; ++k) {
    until(begin + k * span);
    out_mass[static_cast<std::size_t>(k)] = mass_between(-1e9, -2 * d);
  }
  out.early = (out_mass[1] - out_mass[0]) / span;
  out.late = (out_mass[2] - out_mass[1]) / span;
  return out;
}

/// Degrees. A cone's mean height is h/4 and its mean radius r/2, so tan = 2 mean height/mean radius.
double heap_angle(const PairProperties& pair, std::uint64_t seed, Loads loads) {
  constexpr double d = 0.01, cylinder = 0.045;
  Scene scene = grains(pair);
  scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1},
                 {"cylinder", ProfileShape{{{cylinder, 0}, {cylinder, 0.3}}}, LinearMotion{{0, 0, 0.08}}, 2}};
  Stage stage(scene, loads);
  stage.insert(fill(d, cylinder, 0.16, seed));
  stage.advance(static_cast<int>(std::lround(2.0 / dt)));
  const ParticleSnapshot s = stage.dem().particles();
  double height = 0, radius = 0, mass = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    const double r = std::hypot(s.position[k].x, s.position[k].y);
    if (r > 0.15) continue;  // rolled away
    height += s.mass[k] * s.position[k].z;
    radius += s.mass[k] * r;
    mass += s.mass[k];
  }
  return std::atan(2 * (height / mass) / (radius / mass)) * 180 / pi;
}

struct Repose {
  double mean = 0, spread = 0;  ///< over five seeds [degrees]
};

Repose heaps(const PairProperties& pair, Loads loads) {
  double low = 90, high = 0, sum = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const double angle = heap_angle(pair, seed, loads);
    low = std::min(low, angle);
    high = std::max(high, angle);
    sum += angle / 5;
  }
  return {sum, 0.5 * (high - low)};
}

}  // namespace

void silo(Recorder& out) {
  constexpr double d = 0.005;
  const std::array<double, 3> orifices{8 * d, 10 * d, 12.5 * d};
  std::array<double, 3> x{}, y{};
  const std::string law = "Beverloo: C rho_b sqrt(g) (D - k d)^2.5, C 0.58, k 1.4";
  for (std::size_t n = 0; n < orifices.size(); ++n) {
    const Outflow flow = drain(d, orifices[n], out.loads());
    const double free = orifices[n] - 1.4 * d;
    const std::string name = "at-" + std::to_string(std::lround(10 * orifices[n] / d)) + "e-1-diameters";
    out.within(name + "-prefactor", flow.rate() / (flow.bulk_density * std::sqrt(gravity) * std::pow(free, 2.5)),
               0.58 * 0.85, 0.58 * 1.15, law);
    out.relative(name + "-late-over-early", flow.late, flow.early, {0.05, 0.05}, "does not depend on the filling");
    x[n] = std::log(free);
    y[n] = std::log(flow.rate());
  }
  const double mx = (x[0] + x[1] + x[2]) / 3, my = (y[0] + y[1] + y[2]) / 3;
  double xx = 0, xy = 0;
  for (std::size_t n = 0; n < 3; ++n) {
    xx += (x[n] - mx) * (x[n] - mx);
    xy += (x[n] - mx) * (y[n] - my);
  }
  out.within("exponent", xy / xx, 2.4, 2.6, law);
}

void repose(Recorder& out) {
  const auto record = [&](const std::string& name, const PairProperties& pair) {
    const Repose r = heaps(pair, out.loads());
    out.within(name, r.mean, 2, 60, "no closed form; the mean of five seeds [degrees]");
    out.within(name + "-scatter", r.spread, 0, 1.5, "half the range over five seeds [degrees]");
    return r.mean;
  };
  const double smooth = record("friction-0-2", {0.2, 0.5, 0.1}), middle = record("friction-0-5", {0.5, 0.5, 0.1}),
               rough = record("friction-0-8", {0.8, 0.5, 0.1});
  out.within("rise-from-0-2-to-0-5", middle - smooth, 0, 40, "steeper with friction");
  out.within("rise-from-0-5-to-0-8", rough - middle, 0, 40, "steeper with friction");
  const double round = record("rolling-0-02", {0.5, 0.5, 0.02}), edged = record("rolling-0-3", {0.5, 0.5, 0.3});
  out.within("rise-from-0-02-to-0-1-rolling", middle - round, 0, 40, "steeper with rolling friction");
  out.within("rise-from-0-1-to-0-3-rolling", edged - middle, 0, 40, "steeper with rolling friction");
}

}  // namespace gyro::verify
