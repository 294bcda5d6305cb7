// SPDX-License-Identifier: GPL-3.0-or-later
// Crushes a bonded rock in a small gyratory crusher whose motor slows down as the rock resists. Needs
// gyrosim::simulation, which couples gyrosim::engine and gyrosim::drivetrain.
#include "app/simulation/simulation.hpp"
#include "app/simulation/time_step.hpp"
#include "core/dem/make_dem.hpp"
#include "core/rocks/library.hpp"

#include <cstdio>
#include <numbers>

using namespace gyro;

namespace {

constexpr double rpm = std::numbers::pi / 30;  // [rad/s]

/// Mantle and concave as cones. Of a profile's two sides, rock is on the left of the direction of travel.
std::vector<Wall> make_liners() {
  const GyrationMotion gyration{.eccentricity = 0.0027, .pivot_height = 0.525};
  return {{.name = "concave", .shape = ProfileShape{{{0.137, 0}, {0.197, 0.3}}}, .motion = Fixed{}, .material = 1},
          {.name = "mantle", .shape = ProfileShape{{{0.085, 0.3}, {0.119, 0}}}, .motion = gyration, .material = 1}};
}

/// One rock of 45 mm, five particles across, held between the liners at t = 0.
void add_rock(Setup& setup) {
  LibraryRecipe recipe;
  recipe.shapes = ProceduralShapes{.count = 1};
  recipe.sizes = PassingTable{{{0.044, 0}, {0.046, 1}}};
  recipe.samples = 1;
  recipe.fill = MonoFill{5};
  recipe.rock_density = setup.scene.materials[0].density;
  recipe.bond_parameters = *setup.scene.bonds;
  recipe.bed = bed_contacts(setup.scene);
  setup.library = make_library(recipe);
  setup.feed = FeedPlan{};
  setup.feed->fixed = {{0, {0.135, 0, 0.16}}};
}

DrivetrainParameters make_drive() {
  DrivetrainParameters drive;
  drive.motor = DroopMotor{.synchronous_speed = 1697 * rpm, .stall_torque = 6.25};
  drive.gear_ratio = 3.75;
  drive.motor_inertia = 1.526e-3;
  drive.eccentric_inertia = 0.1526;
  return drive;
}

}  // namespace

int main() {
  Setup setup;
  setup.scene.materials = {{"rock", 2600, 139e6, 0.35}, {"steel", 7800, 70e9, 0.3}};
  const PairProperties rock_rock{.friction = 0.5, .restitution = 0.2}, rock_steel{.friction = 0.7, .restitution = 0.25};
  setup.scene.pairs = {rock_rock, rock_steel, rock_steel, {}};
  setup.scene.bonds = BondParameters{
      .normal_stiffness = 100e9, .shear_stiffness = 40e9, .tensile_strength = 9e6, .shear_strength = 6e6};
  setup.scene.walls = make_liners();
  add_rock(setup);
  set_step(setup);

  Simulation run(setup, make_cpu_dem(setup.scene, Precision::mixed, 1), Drivetrain(make_drive()));
  std::printf("time_ms,eccentric_rpm,broken_bonds,fragments,motor_work_J,crushing_work_J\n");
  for (int row = 1; row <= 25; ++row) {
    while (run.time() < row * 0.01) {
      run.advance();
      run.require_sound();
    }
    const DrivetrainState& drive = run.drivetrain()->state();
    std::printf("%.0f,%.2f,%lld,%lld,%.3f,%.3f\n", run.time() * 1e3, drive.speed / rpm,
                static_cast<long long>(run.bonds_initial() - run.dem().counts().bonds_intact),
                static_cast<long long>(run.fragments()), drive.motor_work, drive.rock_work);
  }
}
