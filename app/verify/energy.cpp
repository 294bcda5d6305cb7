// SPDX-License-Identifier: GPL-3.0-or-later
// The energies of a crushed rock add up to the work of the plates.
#include "app/verify/bonded.hpp"
#include "app/verify/check.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gyro::verify {
namespace {

/// A rock of 64 spheres between two plates that close at 2 m/s together, for 8 ms.
EnergyTerms crush(Loads loads, double dt, std::int64_t& broken) {
  BondParameters bonds = paper_bonds();
  bonds.damping = 0.05;
  bonds.tensile_strength = 3.6e6;
  bonds.shear_strength = 2.4e6;
  NewRock rock = placed(lattice(0, 4, bond_radius), 0, 0, {0, 0, 0}, turn_by({0.3, 0.4, 0}));
  scatter_strength(rock);
  double top = 0;
  for (const NewParticle& p : rock.particles) top = std::max(top, std::abs(p.position.z) + p.radius);
  Scene scene = bonded_scene(dt, bonds, {0.5, 0.25, 0.02});
  scene.walls = {{"top", PlaneShape{{0, 0, top}, {0, 0, -1}}, LinearMotion{{0, 0, -1}}, 1},
                 {"bottom", PlaneShape{{0, 0, -top}, {0, 0, 1}}, LinearMotion{{0, 0, 1}}, 1}};
  Stage stage(scene, loads);
  stage.insert({rock});
  for (int k = 0; k < 10; ++k) stage.advance(static_cast<int>(std::llround(0.0008 / dt)));
  broken = stage.dem().counts().broken_tension + stage.dem().counts().broken_shear;
  return stage.dem().energy();
}

void crushing(Recorder& out) {
  std::vector<double> residuals;
  for (const double step : {2e-6, 1e-6, 5e-7, 2.5e-7}) {
    std::int64_t broken = 0;
    const EnergyTerms e = crush(out.loads(), step, broken);
    residuals.push_back(std::abs(e.residual()) / e.wall_work);
    const std::string name = std::to_string(std::lround(step * 1e9)) + "-ns";
    out.absolute("residual-" + name, residuals.back(), 0, {5e-3, 5e-3}, "first law");
    out.within("broken-bonds-" + name, static_cast<double>(broken), 21, 144, "a crush, not a squeeze");
  }
  out.within("residual-falls", residuals.back() / residuals.front(), 0, 0.3, "first order in the step or better");
}

const std::array<Case, 1> cases{{{"energy/crush", crushing}}};

}  // namespace

std::span<const Case> energy_cases() {
  return cases;
}

}  // namespace gyro::verify
