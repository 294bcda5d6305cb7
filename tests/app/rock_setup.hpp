// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/time_step.hpp"
#include "core/rocks/library.hpp"

namespace gyro::test {

/// A setup with a library of one bonded rock of 60 mm. It has no walls, no feed and no time step. Material 1 is steel.
inline Setup rock_setup() {
  Setup setup;
  Scene& scene = setup.scene;
  scene.materials = {{"rock", 2600, 557e6, 0.35}, {"steel", 7800, 70e9, 0.3}};
  scene.pairs = {{0.5, 0.2, 0}, {0.7, 0.25, 0}, {0.7, 0.25, 0}, {0, 1, 0}};
  scene.bonds = BondParameters{1.67e12, 6.67e11, 36e6, 24e6, 0.05, 0, 0};
  LibraryRecipe recipe;
  recipe.shapes = ProceduralShapes{1};
  recipe.sizes = PassingTable{{{0.059, 0}, {0.061, 1}}};
  recipe.samples = 1;
  recipe.fill = MonoFill{4};
  recipe.rock_density = 2600;
  recipe.bond_rule = {0.05, RelativeBondRadius{0.5}};
  recipe.bond_parameters = *scene.bonds;
  recipe.bed = bed_contacts(scene);
  setup.library = make_library(recipe);
  return setup;
}

}  // namespace gyro::test
