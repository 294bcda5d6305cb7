// SPDX-License-Identifier: GPL-3.0-or-later
// Spheres that slide and roll on floors, inclines and belts: closed forms of rigid-body mechanics.
#include "tests/catch.hpp"
#include "tests/core/dem/scenes.hpp"

using namespace gyro;
using namespace gyro::test;

namespace {

constexpr double g = 9.81, radius = 0.01, dt = 1e-5;

/// A sphere that rests on a floor at z = 0, at its static overlap, under a gravity that leans by
/// `slope` towards +x.
struct OnFloor {
  Scene scene = plain_scene(dt);
  std::unique_ptr<Dem> dem;
  std::int64_t step = 0;

  OnFloor(Loads loads, PairProperties pair, double slope, double speed, double spin) {
    scene.materials[1] = rigid();
    scene.pairs.assign(4, pair);
    scene.rolling = pair.rolling_friction > 0;
    scene.gravity = {g * std::sin(slope), 0, -g * std::cos(slope)};
    scene.walls = {{"floor", PlaneShape{{0, 0, 0}, {0, 0, 1}}, Fixed{}, 1}};
    dem = make_cpu_dem(scene, loads, 1);
    const Material& m = scene.materials[0];
    const double plane = 2 * m.shear_modulus * (1 + m.poisson_ratio) / (1 - m.poisson_ratio * m.poisson_ratio);
    const double weight = sphere_mass(radius, 2600) * g * std::cos(slope);
    const double depth = std::pow(weight / (4.0 / 3 * plane * std::sqrt(radius)), 2.0 / 3);
    const std::vector<NewRock> one{sphere(0, {0, 0, radius - depth}, {speed, 0, 0}, radius, 2600, {0, spin, 0})};
    dem->insert(one);
  }
  void go(double seconds) { run(*dem, dt, step, std::llround(seconds / dt), 1000); }
  double x() const { return dem->particles().position[0].x; }
  double v() const { return dem->particles().velocity[0].x; }
  double w() const { return dem->particles().spin[0].y; }
};

}  // namespace

TEST_CASE("A sliding sphere comes to roll", "[dem][contact]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const double mu = 0.5, end = 2.0 / (7 * mu * g);
  OnFloor s(loads, {mu, 0.5, 0}, 0, 1, 0);
  s.go(0.04);
  CHECK(s.v() == Approx(1 - mu * g * 0.04).epsilon(5e-4));
  CHECK(s.w() * radius == Approx(2.5 * mu * g * 0.04).epsilon(5e-4));
  double rolls_at = 0;
  while (rolls_at == 0 && s.step * dt < 0.08) {
    run(*s.dem, dt, s.step, 1);
    if (s.v() <= s.w() * radius) rolls_at = static_cast<double>(s.step) * dt;
  }
  CHECK(rolls_at == Approx(end).epsilon(5e-3));
  CHECK(s.x() == Approx(12 / (49 * mu * g)).epsilon(5e-3));
  s.go(0.05);
  CHECK(s.v() == Approx(5.0 / 7).epsilon(5e-4));
  CHECK(s.w() * radius == Approx(5.0 / 7).epsilon(5e-4));
}

TEST_CASE("Rolling friction stops a sphere after 7 v2/(10 mu_r g) and holds it", "[dem][contact]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const double mu_r = 0.05, v = 0.2;
  OnFloor s(loads, {0.5, 0.5, mu_r}, 0, v, v / radius);
  s.go(0.3);
  CHECK(s.v() == Approx(v - 5.0 / 7 * mu_r * g * 0.3).epsilon(5e-3));
  s.go(0.4);
  CHECK(s.x() == Approx(7 * v * v / (10 * mu_r * g)).epsilon(5e-3));
  s.go(0.1);
  CHECK(std::abs(s.w()) < 1e-9);
  CHECK(std::abs(s.v()) < 1e-9);
}

TEST_CASE("A spinning sphere on a smooth floor is slowed by rolling friction alone", "[dem][contact]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  OnFloor s(loads, {0, 0.5, 0.02}, 0, 0, 50);
  s.go(0.2);
  CHECK(s.w() == Approx(50 - 2.5 * 0.02 * g / radius * 0.2).epsilon(1e-3));
  CHECK(s.v() == 0);
}

TEST_CASE("A sphere on an incline slips or rolls", "[dem][contact]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const double slope = M_PI / 6;
  const double mu = GENERATE(0.10, 0.30);  // 3.5 mu below and above tan(30)
  OnFloor s(loads, {mu, 0.5, 0}, slope, 0, 0);
  s.go(0.05);
  const double v = s.v(), w = s.w();
  s.go(0.15);
  const double a = (s.v() - v) / 0.15, alpha = (s.w() - w) / 0.15;
  if (mu < 0.2) {
    CHECK(a == Approx(g * (std::sin(slope) - mu * std::cos(slope))).epsilon(2e-3));
    CHECK(alpha == Approx(2.5 * mu * g * std::cos(slope) / radius).epsilon(2e-3));
  } else {
    CHECK(a == Approx(5.0 / 7 * g * std::sin(slope)).epsilon(2e-3));
    CHECK(alpha * radius == Approx(a).epsilon(2e-3));
  }
}

TEST_CASE("Rolling friction on an incline slows or holds", "[dem][contact]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const double slope = 0.1;
  OnFloor rolls(loads, {0.5, 0.5, 0.04}, slope, 0, 0);
  rolls.go(0.05);
  const double v = rolls.v();
  rolls.go(0.2);
  CHECK((rolls.v() - v) / 0.2 == Approx(5.0 / 7 * g * (std::sin(slope) - 0.04 * std::cos(slope))).epsilon(5e-3));

  // The resistance balances the slope with a lag of one step: what is left is a creep below
  // (5/2) g sin(slope) dt, which vanishes with dt.
  OnFloor holds(loads, {0.5, 0.5, 0.2}, slope, 0, 0);
  holds.go(0.25);
  CHECK(std::abs(holds.v()) < 2.5 * g * std::sin(slope) * dt * 1.01);
}

TEST_CASE("A belt takes a sphere to 2/7 of its speed and a block of three to all of it", "[dem][contact][bond]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const double mu = 0.5, belt = 1;
  Scene scene = plain_scene(dt);
  scene.materials[1] = rigid();
  scene.pairs.assign(4, {mu, 0.5, 0});
  scene.gravity = {0, 0, -g};
  scene.bonds = BondParameters{2e9, 1e9, 1e9, 1e9, 0.05};
  MeshShape quad{{{-3, -1, 0}, {3, -1, 0}, {3, 1, 0}, {-3, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  scene.walls = {{"belt", quad, LinearMotion{{belt, 0, 0}}, 1}};
  const auto dem = make_cpu_dem(scene, loads, 1);
  NewRock block;
  block.id = 0;
  const double depth = 6e-7, z = radius - depth;
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * M_PI * k / 3, r = 2 * radius / std::sqrt(3.0);
    block.particles.push_back(
        {ParticleId(k), {r * std::cos(angle), 0.3 + r * std::sin(angle), z}, {0, 0, 0}, {0, 0, 0}, radius, 2600});
  }
  block.bonds = {
      {0, 1, 2 * radius, radius / 2, 1}, {1, 2, 2 * radius, radius / 2, 1}, {0, 2, 2 * radius, radius / 2, 1}};
  block.colour_begin = {0, 1, 2, 3};
  const std::vector<NewRock> rocks{block, sphere(3, {0, -0.3, z}, {0, 0, 0}, radius, 2600)};
  dem->insert(rocks);
  std::int64_t step = 0;
  const auto block_speed = [](const ParticleSnapshot& s) {
    return (s.velocity[0].x + s.velocity[1].x + s.velocity[2].x) / 3;
  };
  run(*dem, dt, step, 5000, 1000);
  CHECK(dem->particles().velocity[3].x == Approx(mu * g * 0.05).epsilon(5e-3));
  run(*dem, dt, step, 5000, 1000);
  CHECK(dem->particles().velocity[3].x == Approx(2.0 / 7).epsilon(5e-3));
  CHECK(block_speed(dem->particles()) == Approx(mu * g * 0.1).epsilon(5e-3));
  run(*dem, dt, step, 12000, 1000);
  CHECK(block_speed(dem->particles()) == Approx(belt).epsilon(5e-3));
  CHECK(dem->counts().bonds_intact == 3);
}
