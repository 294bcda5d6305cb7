// SPDX-License-Identifier: GPL-3.0-or-later
// A floor of particle sizes: small rocks get fewer particles than the ratio asks for.
#include "core/base/errors.hpp"
#include "core/rocks/floor_saving.hpp"
#include "tests/catch.hpp"
#include "tests/core/rocks/libraries.hpp"

#include <cmath>

using namespace gyro;

namespace {

LibraryRecipe graded_recipe(double floor) {
  LibraryRecipe recipe = small_recipe();
  recipe.fill = MonoFill{6, MonoFill::Surface::cut, floor};
  recipe.samples = 8;
  return recipe;
}

/// Number of particles of a mass of feed, each rock standing for the same mass.
double particles_per_volume(const RockLibrary& library) {
  double sum = 0;
  for (const RockTemplate& rock : library.rocks) sum += static_cast<double>(rock.centres.size()) / rock.solid_volume;
  return sum;
}

double steps_per_volume(const RockLibrary& library) {
  double sum = 0;
  for (const RockTemplate& rock : library.rocks)
    sum += static_cast<double>(rock.centres.size()) / rock.solid_volume / rock.bond_step;
  return sum;
}

}  // namespace

TEST_CASE("Particle diameters with a floor") {
  const MonoFill fill{6, MonoFill::Surface::cut, 0.02};
  CHECK(particle_diameter(fill, 0.03) == Approx(0.01));  // a third of the rock, below the floor
  CHECK(particle_diameter(fill, 0.06) == Approx(0.02));  // a third of the rock and the floor
  CHECK(particle_diameter(fill, 0.09) == Approx(0.02));  // the floor
  CHECK(particle_diameter(fill, 0.12) == Approx(0.02));  // the floor and the ratio
  CHECK(particle_diameter(fill, 0.48) == Approx(0.08));  // the ratio
  const MonoFill coarse{2.5, MonoFill::Surface::cut, 0.02};
  CHECK(particle_diameter(coarse, 0.03) == Approx(0.012));  // a ratio below 3 is kept
  const MonoFill none{6};
  CHECK(particle_diameter(none, 0.03) == Approx(0.005));
}

TEST_CASE("A floor changes the small rocks of a library and keeps the others to the last bit") {
  const RockLibrary plain = make_library(graded_recipe(0)), graded = make_library(graded_recipe(0.03));
  REQUIRE(plain.rocks.size() == graded.rocks.size());
  int kept = 0;
  for (std::size_t k = 0; k < plain.rocks.size(); ++k) {
    const RockTemplate& rock = graded.rocks[k];
    CAPTURE(rock.name);
    CHECK(rock.radii[0] == Approx(std::max(rock.diameter / 6, std::min(0.03, rock.diameter / 3)) / 2));
    CHECK(std::abs(rock.mass_error) < 1e-12);
    CHECK(rock.solid_volume == plain.rocks[k].solid_volume);
    const bool above = rock.diameter >= 6 * 0.03;
    CHECK(same_rock(rock, plain.rocks[k]) == above);
    kept += above ? 1 : 0;
  }
  CHECK(kept > 0);
  CHECK(kept < 8);
}

TEST_CASE("What a floor saves is known from the graded library alone") {
  for (const bool absolute : {false, true}) {
    LibraryRecipe with = graded_recipe(0.03), without = graded_recipe(0);
    if (absolute) with.bond_rule.radius = without.bond_rule.radius = AbsoluteBondRadius{0.004};
    const RockLibrary graded = make_library(with), plain = make_library(without);
    const FloorSaving saving = floor_saving(with, graded);
    CHECK(saving.smallest == Approx(graded.rocks.front().diameter / 3));
    CHECK(saving.largest == Approx(graded.rocks.back().diameter / 6));
    // Counts of small rocks scatter by their surface, and their modes with them.
    CHECK(saving.particles == Approx(particles_per_volume(plain) / particles_per_volume(graded)).epsilon(0.1));
    CHECK(saving.particle_steps == Approx(steps_per_volume(plain) / steps_per_volume(graded)).epsilon(0.2));
    CHECK(saving.particles > 1.5);
    CHECK(saving.particle_steps > 1.2 * saving.particles);
  }
}

TEST_CASE("Without effect a floor saves nothing, and a bad one is refused") {
  const LibraryRecipe recipe = graded_recipe(0.001);
  const FloorSaving saving = floor_saving(recipe, make_library(recipe));
  CHECK(saving.particles == 1);
  CHECK(saving.particle_steps == 1);
  CHECK_THROWS_AS(check_rule(MonoFill{6, MonoFill::Surface::cut, -0.01}), BadInput);
  CHECK_THROWS_AS(check_rule(MonoFill{6, MonoFill::Surface::cut, NAN}), BadInput);
}
