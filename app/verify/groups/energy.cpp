// SPDX-License-Identifier: GPL-3.0-or-later
// The energies of a crushed rock add up to the work of the plates.
#include "app/verify/fixtures/plate_crush.hpp"
#include "app/verify/fixtures/rocks.hpp"
#include "app/verify/fixtures/scenes.hpp"
#include "app/verify/fixtures/stage.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gyro::verify {
namespace {

using namespace fixtures;

EnergyTerms crush(Precision precision, double dt, std::int64_t& broken) {
  const PlateCrush crush(dt);
  Stage stage(crush.scene, precision);
  stage.insert({crush.rock});
  for (int k = 0; k < 10; ++k) stage.advance(static_cast<int>(std::llround(PlateCrush::duration / 10 / dt)));
  broken = stage.dem().counts().broken_tension + stage.dem().counts().broken_shear;
  return stage.dem().energy();
}

void crushing(Recorder& out) {
  std::vector<double> residuals;
  for (const double step : {2e-6, 1e-6, 5e-7, 2.5e-7}) {
    std::int64_t broken = 0;
    const EnergyTerms e = crush(out.precision(), step, broken);
    residuals.push_back(std::abs(e.residual()) / e.wall_work);
    const std::string name = std::to_string(std::lround(step * 1e9)) + "-ns";
    out.absolute("residual-" + name, residuals.back(), 0, {5e-3, 5e-3}, "first law");
    out.within("broken-bonds-" + name, static_cast<double>(broken), 21, 144, "the rock is crushed");
  }
  out.within("residual-falls", residuals.back() / residuals.front(), 0, 0.3, "first order in the step or better");
}

/// Two bonded spheres of different size spin against each other without damping, so that their bond is bent and twisted
/// by about 0.3 rad.
/// @return the largest relative change of their energy in 2 ms
double change_of_energy(Precision precision, double dt) {
  BondParameters bonds = paper_bonds();
  bonds.tensile_strength = bonds.shear_strength = 1e15;
  NewRock rock = chain(0, 1);
  rock.particles[1].radius *= 0.7;
  rock.particles[0].angular_velocity = {5000, 2000, 1000};
  rock.particles[1].angular_velocity = {-6000, 1000, 3000};
  Stage stage(bonded_scene(dt, bonds), precision);
  stage.insert({rock});
  const double energy = stage.dem().energy().kinetic;
  double largest = 0;
  for (int k = 0; k < 200; ++k) {
    stage.advance(static_cast<int>(std::llround(1e-5 / dt)));
    const EnergyTerms e = stage.dem().energy();
    largest = std::max(largest, std::abs((e.kinetic + e.bond_elastic) / energy - 1));
  }
  return largest;
}

/// The loads must be the exact gradient of the stored energy. If they were so only to first order in the strains, an
/// error would remain that does not fall with the step.
void far_strained(Recorder& out) {
  const double coarse = change_of_energy(out.precision(), 4e-7), fine = change_of_energy(out.precision(), 1e-7);
  out.absolute("change-at-100-ns", fine, 0, {3e-5, 3e-5}, "conservative loads");
  out.within("order", std::log2(coarse / fine) / 2, 1.8, 2.2, "velocity Verlet");
}

}  // namespace

std::vector<Verification> energy_cases() {
  return {{"energy/crush", crushing}, {"energy/far-strained-bond", far_strained}};
}

}  // namespace gyro::verify
