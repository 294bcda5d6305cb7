// SPDX-License-Identifier: GPL-3.0-or-later
// Waves along a bar of fifty bonded spheres.
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/signal.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

using namespace fixtures;
using std::numbers::pi;

constexpr int length = 50;         // spheres beyond the clamped one
constexpr double speed = 1963.12;  // of long waves: L sqrt(kn A/m) [m/s]

/// Velocity of sphere k of a semi-infinite chain whose end moves with the velocity 1 from time 0 on:
///   J_2k(tau) + 2 J_2k+2(tau) + 2 J_2k+4(tau) ...  with tau = 2 sqrt(k/m) t
double chain_velocity(int sphere, double tau) {
  double sum = std::cyl_bessel_j(2 * sphere, tau);
  for (int order = 2 * sphere + 2; order < 2 * sphere + 60; order += 2) sum += 2 * std::cyl_bessel_j(order, tau);
  return sum;
}

/// Time tau at which sphere k reaches half the velocity of the end, by bisection.
double half_time(int sphere) {
  double low = 0, high = 2.0 * sphere + 8;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (chain_velocity(sphere, middle) < 0.5 ? low : high) = middle;
  }
  return low;
}

/// The clamped sphere starts to move at constant velocity: times at which spheres 10, 20, 30 and 40 reach half of it.
void front(Recorder& out) {
  constexpr double push = 1e-3;
  Stage stage(bonded_scene(2e-7, paper_bonds()), out.precision());
  NewRock rock = cantilever(0, length);
  rock.particles[0].velocity = {push, 0, 0};
  stage.insert({rock});
  std::array<double, 5> arrival{};
  std::vector<double> before(length + 1, 0.0);
  while (arrival[4] == 0 && stage.time() < 1e-3) {
    stage.advance(1);
    const ParticleSnapshot s = stage.dem().particles();
    for (std::size_t k = 1; k < arrival.size(); ++k) {
      const double v = s.velocity[10 * k].x / push;
      if (arrival[k] == 0 && v >= 0.5) arrival[k] = stage.time() - stage.dt() * (v - 0.5) / (v - before[10 * k]);
      before[10 * k] = v;
    }
  }
  out.relative("speed-at-half-height", 30 * grain / (arrival[4] - arrival[1]), speed, {0.01, 0.01}, "L sqrt(kn A/m)");
  for (const int k : {1, 4}) {
    const double exact = half_time(10 * k) * grain / (2 * speed);
    out.relative("arrival-at-" + std::to_string(10 * k), arrival[static_cast<std::size_t>(k)], exact, {1e-4, 1e-4},
                 "Bessel solution of the discrete chain");
  }
}

/// Frequency of mode j of a bar that is clamped at one end [Hz]: its wave number is q = (2 j - 1) pi/((2 n + 1) L).
double mode_frequency(int j, double stiffness, double inertia) {
  return std::sqrt(stiffness / inertia) / pi * std::sin((2 * j - 1) * pi / (2 * (2 * length + 1)));
}

void dispersion(Recorder& out) {
  const BondStiffness k(paper_bonds());
  const double mass = sphere_mass(grain / 2, rock_density);
  for (const int j : {1, 10, 25, 40, 50}) {
    const double exact = mode_frequency(j, k.normal, mass);
    constexpr int samples = 800;
    const int every = static_cast<int>(std::ceil(20 / exact / samples / 3e-7 / (j < 10 ? 10 : 1)));
    Stage stage(bonded_scene(20 / exact / samples / every, paper_bonds()), out.precision());
    NewRock rock = cantilever(0, length);
    for (int p = 1; p <= length; ++p)
      rock.particles[static_cast<std::size_t>(p)].velocity.x = 1e-3 * std::sin((2 * j - 1) * pi * p / (2 * length + 1));
    stage.insert({rock});
    Signal velocity{every * stage.dt(), {}};
    for (int s = 0; s < samples; ++s) {
      stage.advance(every);
      velocity.x.push_back(stage.dem().particles().velocity[1].x);
    }
    out.relative("mode-" + std::to_string(j), velocity.line_near(exact), exact, {2e-4, 2e-4},
                 "2 sqrt(kn A/m) sin(q L/2)");
  }
}

}  // namespace

std::vector<Verification> wave_cases() {
  return {
      {"wave/front", front},
      {"wave/dispersion", dispersion},
  };
}

}  // namespace gyro::verify
