// SPDX-License-Identifier: GPL-3.0-or-later
// Beams of bonded spheres against their exact discrete solutions. A sphere of great density is the clamp.
#include "tests/catch.hpp"
#include "tests/core/dem/scenes.hpp"

#include <complex>

using namespace gyro;
using namespace gyro::test;

namespace {

constexpr double d = 0.025, bond_radius = 0.005;
const double area = M_PI * bond_radius * bond_radius;
const double normal_rate = 1.67e12 * area, shear_rate = 6.67e11 * area;
const double bend_rate = normal_rate * bond_radius * bond_radius / 4;

/// A clamp and n spheres along x.
NewRock beam(int n) {
  NewRock rock;
  rock.id = 0;
  for (int k = 0; k <= n; ++k)
    rock.particles.push_back({ParticleId(k), {k * d, 0, 0}, {0, 0, 0}, {0, 0, 0}, d / 2, k == 0 ? 2.6e21 : 2600});
  rock.colour_begin = {0};
  for (int odd = 0; odd < 2; ++odd) {
    for (int k = odd; k < n; k += 2) rock.bonds.push_back({k, k + 1, d, bond_radius, 1});
    rock.colour_begin.push_back(static_cast<Index>(rock.bonds.size()));
  }
  return rock;
}

/// Amplitude of a frequency in samples at dt, with a Hann window.
double amplitude(const std::vector<double>& x, double dt, double frequency) {
  std::complex<double> sum = 0;
  const double n = static_cast<double>(x.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    sum += x[k] * (1 - std::cos(2 * M_PI * (double(k) + 0.5) / n)) *
           std::polar(1.0, -2 * M_PI * frequency * dt * double(k));
  return std::abs(sum);
}

/// Frequency of the line near a guess: the highest point of its lobe, by golden section.
double line_near(const std::vector<double>& x, double dt, double guess) {
  const double reach = 1.5 / (dt * static_cast<double>(x.size()));
  double low = guess - reach, high = guess + reach;
  for (int k = 0; k < 50; ++k) {
    const double a = high - 0.618034 * (high - low), b = low + 0.618034 * (high - low);
    if (amplitude(x, dt, a) < amplitude(x, dt, b))
      low = a;
    else
      high = b;
  }
  return (low + high) / 2;
}

}  // namespace

TEST_CASE("A cantilever bends under a tip load as the discrete beam does", "[dem][bond]") {
  // A smooth plane presses on the last sphere from the start; damping brings the beam to rest.
  //   deflection/load = L2 n (4 n2 - 1)/(12 kn I) + n/(ks A)
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const int n = 5;
  const double dt = 1e-6, press = 5e-6;
  Scene scene = plain_scene(dt);
  scene.bonds = paper_bonds();
  scene.bonds->damping = 0.3;
  scene.pairs.assign(4, {0, 0.05, 0});
  MeshShape tip{{{n * d - d / 3, -d, d / 2 - press}, {n * d + d, -d, d / 2 - press}, {n * d, 2 * d, d / 2 - press}},
                {{0, 1, 2}}};
  scene.walls = {{"tip", tip, Fixed{}, 1}};
  const auto dem = make_cpu_dem(scene, loads, 1);
  const std::vector<NewRock> rocks{beam(n)};
  dem->insert(rocks);
  std::int64_t step = 0;
  run(*dem, dt, step, 150000, 5000);
  const ParticleSnapshot s = dem->particles();
  const double deflection = -s.position[n].z, load = dem->wall_loads()[0].force.z;
  REQUIRE(norm(s.velocity[n]) < 1e-10);
  REQUIRE(load > 0.05);
  const double exact = d * d * n * (4 * n * n - 1) / (12 * bend_rate) + n / shear_rate;
  CHECK(exact == Approx(3.154522e-5).epsilon(1e-6));
  CHECK(deflection / load == Approx(exact).epsilon(loads == Loads::double_ ? 2e-6 : 1e-4));
}

TEST_CASE("First frequencies of a clamped beam are those of the discrete beam", "[dem][bond]") {
  const Loads loads = GENERATE(Loads::double_, Loads::single);
  const int n = 5, every = 10;
  const double dt = 2e-6;
  Scene scene = plain_scene(dt);
  scene.bonds = paper_bonds();
  const auto dem = make_cpu_dem(scene, loads, 1);
  std::vector<NewRock> rocks{beam(n)};
  for (int k = 1; k <= n; ++k) {
    NewParticle& p = rocks[0].particles[std::size_t(k)];
    const double first_mode = std::sin(M_PI * k / (2.0 * n + 1));
    p.velocity = {1e-3 * first_mode, 0, 1e-3 * k * k / (n * n)};
    p.spin = {1e-1 * first_mode, -1e-3 * 2 * k / (n * n * d), 0};
  }
  dem->insert(rocks);
  std::int64_t step = 0;
  std::vector<double> axial, bending, torsion;
  for (int k = 0; k < 8000; ++k) {  // 23 periods of bending
    run(*dem, dt, step, every);
    const ParticleSnapshot s = dem->particles();
    axial.push_back(s.velocity[n].x);
    bending.push_back(s.velocity[n].z);
    torsion.push_back(s.spin[n].x);
  }
  CHECK(line_near(axial, every * dt, 3557.19) == Approx(3557.19).epsilon(1e-3));
  CHECK(line_near(bending, every * dt, 145.897) == Approx(145.897).epsilon(1e-3));
  CHECK(line_near(torsion, every * dt, 1005.37) == Approx(1005.37).epsilon(1e-3));
}
