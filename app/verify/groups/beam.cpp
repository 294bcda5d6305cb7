// SPDX-License-Identifier: GPL-3.0-or-later
// Cantilevers of bonded spheres against the exact solution of the discrete beam.
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

/// A cantilever of n spheres beyond the clamped one, with the reference values of the discrete beam, in which the
/// spheres are rigid and the bonds bend at mid-gap. The deflection at the tip under a tip load P is
///   deflection/P = L^2 n (4 n^2 - 1)/(12 k_n I) + n/(k_s A).
/// The first bending frequency comes from the eigenvalue problem. The axial and torsional frequencies have the closed
/// form of chain_frequency().
struct Beam {
  int n;
  double compliance, bending;                  ///< deflection/P [m/N], first bending frequency [Hz]
  double slender_compliance, slender_bending;  ///< by Euler and Bernoulli, with E I = k_n I L and length n L
};
constexpr std::array<Beam, 4> beams{{{5, 3.154522e-5, 145.897, 3.176745e-5, 175.767},
                                     {10, 2.536952e-4, 39.904, 2.541396e-4, 43.942},
                                     {20, 2.032228e-3, 10.4594, 2.033117e-3, 10.9855},
                                     {40, 1.626316e-2, 2.6792, 1.626494e-2, 2.7464}}};

const std::string discrete = "L^2 n(4n^2-1)/(12 kn I) + n/(ks A), exact discrete beam";
const std::string eigenvalue = "eigenvalues of the discrete beam";

/// First frequency of a chain of n equal inertias and n equal springs with one fixed end [Hz].
double chain_frequency(int n, double stiffness, double inertia) {
  return std::sqrt(stiffness / inertia) / pi * std::sin(pi / (2 * (2 * n + 1)));
}

struct Bent {
  double compliance, frequency;  ///< [m/N], [Hz]
};

/// Runs two cantilevers without damping for 20 bending periods: a frictionless plate slowly presses the tip of the
/// first one down, and the second one oscillates freely. Means under a smooth window cancel the oscillations of the
/// first one.
Bent bend(const Beam& beam, Precision precision) {
  constexpr int samples = 1600;
  const double time = 20 / beam.bending, length = beam.n * grain;
  const int every = static_cast<int>(std::ceil(time / samples / 8e-6));
  Scene scene = bonded_scene(time / samples / every, paper_bonds(), {0, 0.05, 0});
  // The contact is stiff: its overlap does not grow uniformly, so a soft contact would accelerate the tip.
  scene.materials = {elastic(1.5e12, 0.35, rock_density), rigid()};
  const double edge = length - grain / 3, top = grain / 2;
  scene.walls = {
      {"plate",
       TriangleMesh{{{edge, -grain, top}, {length + grain, -grain, top}, {length, 2 * grain, top}}, {{0, 1, 2}}},
       LinearMotion{{0, 0, -1e-4 * length / time}}, 1}};
  Stage stage(scene, precision);
  NewRock free = placed(cantilever(1, beam.n), 1, 1000, {0, 1, 0});
  for (int k = 1; k <= beam.n; ++k)  // initial velocities close to the first mode
    free.particles[static_cast<std::size_t>(k)].velocity.z = 1e-4 * length * beam.bending * k * k / (beam.n * beam.n);
  stage.insert({cantilever(0, beam.n), free});

  const auto tip = static_cast<std::size_t>(beam.n);
  Signal deflection{every * stage.dt(), {}}, load = deflection, swing = deflection;
  double before = 0;
  for (int k = 0; k < samples; ++k) {
    stage.advance(every);
    const ParticleSnapshot s = stage.dem().particles();
    const double now = -s.position[tip].z;
    deflection.x.push_back(0.5 * (before + now));  // as for the load, which is the mean of both ends of every step
    before = now;
    load.x.push_back(stage.dem().wall_loads()[0].force.z);
    swing.x.push_back(s.position[2 * tip + 1].z);
  }
  return {deflection.mean() / load.mean(), swing.line_near(beam.bending)};
}

void bending(Recorder& out) {
  std::array<Bent, beams.size()> got{};
  for (std::size_t b = 0; b < beams.size(); ++b) {
    got[b] = bend(beams[b], out.precision());
    const std::string n = std::to_string(beams[b].n);
    out.relative("deflection-" + n, got[b].compliance, beams[b].compliance, {1e-6, 1e-6}, discrete);
    out.relative("frequency-" + n, got[b].frequency, beams[b].bending, {2e-4, 2e-4}, eigenvalue);
  }
  // The discrete beam differs from the Euler-Bernoulli beam by terms of order 1/n (frequency) and 1/n^2 (deflection).
  const Bent &coarse = got[2], &fine = got[3];
  const auto order = [](double a, double b) { return std::log2(a / b); };
  out.within("order-to-slender-frequency",
             order(1 - coarse.frequency / beams[2].slender_bending, 1 - fine.frequency / beams[3].slender_bending), 0.9,
             1.1, "Euler-Bernoulli, O(1/n)");
  out.within(
      "order-to-slender-deflection",
      order(1 - coarse.compliance / beams[2].slender_compliance, 1 - fine.compliance / beams[3].slender_compliance),
      1.9, 2.2, "Euler-Bernoulli, O(1/n^2)");
}

/// The first axial and the first torsional mode in one run, as they do not influence each other.
void chain_modes(Recorder& out) {
  const BondStiffness k(paper_bonds());
  const double mass = sphere_mass(grain / 2, rock_density), inertia = 0.1 * mass * grain * grain;
  for (const Beam& beam : beams) {
    const double axial = chain_frequency(beam.n, k.normal, mass),
                 torsional = chain_frequency(beam.n, k.torsion, inertia);
    constexpr int samples = 2000;
    const double time = 20 / torsional;
    const int every = static_cast<int>(std::ceil(time / samples * 200 * axial));
    Stage stage(bonded_scene(time / samples / every, paper_bonds()), out.precision());
    NewRock rock = cantilever(0, beam.n);
    for (int p = 1; p <= beam.n; ++p) {
      const double mode = std::sin(pi * p / (2 * beam.n + 1));
      rock.particles[static_cast<std::size_t>(p)].velocity = {1e-3 * mode, 0, 0};
      rock.particles[static_cast<std::size_t>(p)].angular_velocity = {0.1 * mode, 0, 0};
    }
    stage.insert({rock});
    Signal stretch{every * stage.dt(), {}}, twist = stretch;
    for (int s = 0; s < samples; ++s) {
      stage.advance(every);
      const ParticleSnapshot now = stage.dem().particles();
      stretch.x.push_back(now.velocity.back().x);
      twist.x.push_back(now.angular_velocity.back().x);
    }
    const std::string n = std::to_string(beam.n), theory = "2 sqrt(k/m) sin(pi/(2(2n+1)))";
    out.relative("axial-" + n, stretch.line_near(axial), axial, {2e-4, 2e-4}, theory);
    out.relative("torsional-" + n, twist.line_near(torsional), torsional, {2e-4, 2e-4}, theory);
  }
}

}  // namespace

std::vector<Verification> beam_cases() {
  return {
      {"beam/bending", bending},
      {"beam/along-the-axis", chain_modes},
  };
}

}  // namespace gyro::verify
