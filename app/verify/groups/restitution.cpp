// SPDX-License-Identifier: GPL-3.0-or-later
// Damped normal impacts: test 3 of Chung & Ooi, Granular Matter 13 (2011) 643.
#include "core/laws/contact/restitution.hpp"
#include "app/verify/fixtures/hertz.hpp"
#include "app/verify/fixtures/impact.hpp"
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace gyro::verify {
namespace {

using namespace fixtures;

const std::string source = "prescribed; damping by restitution_of_damping() in core/laws/contact/restitution.hpp";

std::string percent(double e) {
  char text[16];
  std::snprintf(text, sizeof text, "e-%03.0f", 100 * e);
  return text;
}

const double asked[] = {0.05, 0.1, 0.2, 0.25, 0.3, 0.5, 0.7, 0.9, 1};

double rebound(const Material& material, double e, double speed, double steps_per_contact, Precision precision) {
  WallImpact impact{material, {0, e, 0}, 0.0025, {0, 0, -speed}};
  impact.steps_per_contact = steps_per_contact;
  return hit_wall(impact, precision).velocity.z / speed;
}

/// Checks the rebound for all restitutions, and that it is the same at three speeds.
void series(Recorder& out, const Material& material) {
  for (const double e : asked) {
    const double slow = rebound(material, e, 0.1, 1000, out.precision());
    const double middle = rebound(material, e, 3.9, 1000, out.precision());
    const double fast = rebound(material, e, 10, 1000, out.precision());
    out.absolute(percent(e), middle, e, {2e-4, 3e-4}, source);
    out.absolute(percent(e) + "-at-all-speeds", std::max({slow, middle, fast}) - std::min({slow, middle, fast}), 0,
                 {1e-6, 1e-4}, "the law has no scale of speed");
  }
}

/// Checks the error at fifty steps per contact, and that it decreases with the step.
void coarse(Recorder& out) {
  const Material material = elastic(380e9, 0.23, 4000);
  const auto worst = [&](double steps) {
    double error = 0;
    for (const double e : asked)
      error = std::max(error, std::abs(rebound(material, e, 3.9, steps, out.precision()) - e));
    return error;
  };
  const double at_50 = worst(50);
  out.absolute("largest-error-at-50-steps", at_50, 0, {5e-3, 5e-3}, source);
  out.within("error-by-a-tenth-of-the-step", worst(500) / at_50, 0, 0.2, "first order where the force is cut at zero");
}

/// A cube of n^3 spheres falls on the corner that is straight below its centre. Its bonds are so stiff that it moves as
/// one rigid body. @return speed after the impact divided by the speed before
double rock_rebound(int n, double e, double fall, Precision precision) {
  BondParameters bonds = paper_bonds();
  bonds.tensile_strength = bonds.shear_strength = 1e12;
  Scene scene = scene_of(elastic(1e7, 0.35, rock_density), rigid(), {0, e, 0}, 2e-6);
  scene.bonds = bonds;
  scene.walls = {floor_plane()};
  Stage stage(scene, precision);
  // This rotates the body diagonal (1, 1, 1) to (0, 0, -1).
  const double down = std::acos(-1 / std::sqrt(3.0)) / std::sqrt(2.0);
  const double lowest = grain * (0.5 * (n - 1) * std::sqrt(3.0) + 0.5);
  NewRock rock = lattice(0, n, {.bond_radius = grain / 2});
  if (n == 1) rock.colour_begin = {0};
  rock = placed(rock, 0, 0, {0, 0, lowest}, rotation_by(down * Vec3d{1, -1, 0}));
  for (NewParticle& p : rock.particles) p.velocity = {0, 0, -fall};
  stage.insert({rock});
  const double mass = n * n * n * sphere_mass(grain / 2, rock_density);
  const ElasticImpact elastic_one(youngs_against_rigid(scene.materials[0]), grain / 2, mass, fall);
  stage.advance(static_cast<int>(4 * elastic_one.duration / scene.dt));
  return stage.dem().momentum().z / (mass * fall);
}

/// The restitution of a whole rock. The dashpot of a contact is designed for the mass of the touching sphere alone.
/// When a rock of N spheres lands on one of them, N times this mass acts on the same dashpot, so that zeta is smaller
/// by sqrt(N) and the rock rebounds more: a restitution of 0.2 for a single sphere becomes 0.67 for a rock of 27
/// spheres.
void whole_rocks(Recorder& out) {
  for (const double e : {0.2, 0.5})
    for (const int n : {1, 2, 3}) {
      const double zeta = damping_for_restitution(e) / std::pow(n, 1.5);
      out.relative(percent(e) + "-of-" + std::to_string(n * n * n), rock_rebound(n, e, 0.1, out.precision()),
                   restitution_of_damping(zeta), {1e-3, 1e-3}, "N spheres on one: zeta / sqrt(N)");
    }
}

}  // namespace

std::vector<Verification> restitution_cases() {
  return {
      {"restitution/aluminium-oxide", [](Recorder& out) { series(out, elastic(380e9, 0.23, 4000)); }},
      {"restitution/cast-iron", [](Recorder& out) { series(out, elastic(100e9, 0.25, 7000)); }},
      {"restitution/coarse-step", coarse},
      {"restitution/whole-rocks", whole_rocks},
  };
}

}  // namespace gyro::verify
