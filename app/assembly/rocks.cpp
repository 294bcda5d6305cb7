// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/assembly/rocks.hpp"

#include "app/assembly/in_mm.hpp"
#include "app/simulation/setup.hpp"
#include "app/simulation/time_step.hpp"
#include "core/rocks/floor_saving.hpp"
#include "core/rocks/strength.hpp"

#include <algorithm>
#include <cstdio>

namespace gyro {
namespace {

double largest_rock(const RockLibrary& library) {
  double largest = 0;
  for (const RockTemplate& rock : library.rocks) largest = std::max(largest, 2 * rock.bounding_radius);
  return largest;
}

/// Largest extent of a rock of the start state, bounded from its first particle [m].
double largest_extent(std::span<const NewRock> rocks) {
  double largest = 0;
  for (const NewRock& rock : rocks)
    for (const NewParticle& p : rock.particles)
      largest = std::max(largest, norm(p.position - rock.particles.front().position) + 2 * p.radius);
  return largest;
}

/// Where rock appears: the chamber for the initial charge, the opening above a wall for the rest.
void set_regions(FeedPlan& plan, const CaseFeed& feed, const Scene& scene, const RockLibrary& library) {
  if (feed.above == none) return;
  const Wall& outer = scene.walls[static_cast<std::size_t>(feed.above)];
  if (plan.initial > 0) {
    const RadiusByHeight radius(outer, RadiusByHeight::Side::outer);
    ChamberRegion chamber{feed.above, gyrating_wall(scene), std::max(0.0, radius.low()), radius.high()};
    if (feed.initial_top) chamber.high = *feed.initial_top;
    plan.charge = chamber;
  }
  if (plan.rate > 0 || plan.batch > 0) plan.entry = opening_above(outer, 2 * largest_rock(library));
}

}  // namespace

BondStrength bond_strength(const Case& input) {
  if (!input.bonds || !input.bonds->scatter) return {};
  return [scatter = *input.bonds->scatter, seed = input.identity.seed](RockId rock, ParticleId i, ParticleId j) {
    return strength_factor(scatter, seed, rock, i, j);
  };
}

LibraryRecipe library_recipe(const Case& input, const Scene& scene) {
  const CaseRocks& rocks = *input.rocks;
  LibraryRecipe recipe;
  recipe.shapes = recipe_shapes(rocks.shapes);
  recipe.sizes = rocks.sizes;
  recipe.samples = rocks.samples;
  recipe.fill = rocks.fill;
  recipe.rock_density = scene.materials[static_cast<std::size_t>(scene.rock_material)].density;
  recipe.compensated = rocks.density_compensated;
  if (input.bonds) {
    recipe.bond_rule = input.bonds->rule;
    recipe.bond_parameters = *scene.bonds;
  }
  recipe.bed = bed_contacts(scene);
  recipe.seed = input.identity.seed;
  return recipe;
}

std::vector<std::string> floor_notes(const LibraryRecipe& recipe, const RockLibrary& library) {
  const auto* fill = std::get_if<MonoFill>(&recipe.fill);
  if (fill == nullptr || !(fill->floor > 0) || library.rocks.empty()) return {};
  const FloorSaving saving = floor_saving(recipe, library);
  if (saving.particles == 1)
    return {"rocks.fill.floor of " + in_mm(fill->floor) + " changes nothing: the smallest particle has " +
            in_mm(saving.smallest) + " without it"};
  char text[300];
  std::snprintf(
      text, sizeof text,
      "rocks.fill.floor: particles of %.3g to %.3g mm; the ratio alone would need %.1f times as many particles "
      "and %.1f times as many steps of their bonds (times particles)",
      1e3 * saving.smallest, 1e3 * saving.largest, saving.particles, saving.particle_steps);
  return {text};
}

double removal_depth(const RockLibrary& library, std::span<const NewRock> start) {
  return 2 * std::max(largest_rock(library), largest_extent(start));
}

FeedPlan feed_plan(const Case& input, const Scene& scene, const RockLibrary& library, std::span<const NewRock> start) {
  const CaseFeed& feed = *input.feed;
  FeedPlan plan;
  plan.initial = feed.initial;
  plan.batch = feed.mass.value_or(0);
  plan.rate = feed.rate;
  plan.start = feed.start;
  plan.seed = input.identity.seed;
  plan.clearance = std::min(plan.clearance, smallest_radius(library, start));
  set_regions(plan, feed, scene, library);
  Vec3d at = feed.at;
  for (int k = 0; k < feed.rocks; ++k) {
    const Index kind = static_cast<Index>(k % static_cast<int>(library.rocks.size()));
    plan.fixed.push_back({kind, at, {1, 0, 0, 0}});
    at.z += 2.1 * largest_rock(library) / 2;
  }
  for (const NewRock& rock : start) {
    plan.first_rock = std::max(plan.first_rock, static_cast<RockId>(rock.id + 1));
    for (const NewParticle& p : rock.particles) plan.first_particle = std::max(plan.first_particle, p.id + 1);
  }
  return plan;
}

}  // namespace gyro
