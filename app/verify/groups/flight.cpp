// SPDX-License-Identifier: GPL-3.0-or-later
// A rock of 125 spheres that moves and rotates freely, without damping.
#include "app/verify/fixtures/random.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/snapshots.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gyro::verify {
namespace {

using namespace fixtures;

const std::string source = "mechanics of a closed system";

struct Flight {
  double dt;  ///< [s]
  int steps;
  double unequal = 0;  ///< scatter of the radii; with it the two arms of a bond differ
};

Vec3d centre_of_mass(const ParticleSnapshot& s) {
  Vec3d sum{0, 0, 0};
  double mass = 0;
  for (std::size_t k = 0; k < s.size(); ++k) {
    sum += s.mass[k] * s.position[k];
    mass += s.mass[k];
  }
  return (1 / mass) * sum;
}

double total_mass(const ParticleSnapshot& s) {
  double mass = 0;
  for (const double m : s.mass) mass += m;
  return mass;
}

/// Energy of the bonds and of the motion about the centre of mass [J].
double inner_energy(const Dem& dem, double mass) {
  const EnergyTerms e = dem.energy();
  return e.kinetic + e.bond_elastic - 0.5 * norm2(dem.momentum()) / mass;
}

void fly(Recorder& out, const Flight& flight) {
  NewRock rock = lattice(0, 5);
  for (NewParticle& p : rock.particles) p.radius *= 1 - flight.unequal * (1 + random_number(p.id, 0));
  add_rigid_motion(rock, {3, -2, 1}, {30, 60, 80});
  Stage stage(bonded_scene(flight.dt, paper_bonds()), out.precision());
  stage.insert({rock});
  const ParticleSnapshot first = stage.dem().particles();
  const double mass = total_mass(first), energy = inner_energy(stage.dem(), mass);
  const Vec3d momentum = stage.dem().momentum(), angular = angular_momentum(first);
  double energy_error = 0, angular_error = 0, path_error = 0;
  for (int k = 0; k < 20; ++k) {
    stage.advance(flight.steps / 20);
    const ParticleSnapshot now = stage.dem().particles();
    const Vec3d path = (stage.time() / mass) * momentum;
    energy_error = std::max(energy_error, std::abs(inner_energy(stage.dem(), mass) / energy - 1));
    angular_error = std::max(angular_error, norm(angular_momentum(now) - angular) / norm(angular));
    path_error = std::max(path_error, norm(centre_of_mass(now) - centre_of_mass(first) - path) / norm(path));
  }
  out.absolute("angular-momentum", angular_error, 0, {1e-12, 1e-8}, source);
  out.absolute("momentum", norm(stage.dem().momentum() - momentum) / norm(momentum), 0, {1e-12, 1e-8}, source);
  out.absolute("straight-path", path_error, 0, {1e-12, 1e-8}, source);
  out.absolute("energy", energy_error, 0, {1e-6, 1e-6}, source);
}

}  // namespace

std::vector<Verification> flight_cases() {
  return {
      {"flight/1-us",
       [](Recorder& out) {
         fly(out, {1e-6, 300000});
       }},
      {"flight/3-us",
       [](Recorder& out) {
         fly(out, {3e-6, 100000});
       }},
      {"flight/unequal-spheres",
       [](Recorder& out) {
         fly(out, {1e-6, 50000, 0.15});
       }},
  };
}

}  // namespace gyro::verify
