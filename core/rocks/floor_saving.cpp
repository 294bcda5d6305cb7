// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/floor_saving.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {

double bond_step_exponent(const BondRule& rule, const BondParameters& parameters) {
  const double section = std::holds_alternative<AbsoluteBondRadius>(rule.radius) ? 0 : 2;
  const double stiffness = parameters.normal_modulus > 0 ? section - 1 : section;
  return (3 - stiffness) / 2;
}

FloorSaving floor_saving(const LibraryRecipe& recipe, const RockLibrary& library) {
  const auto& fill = std::get<MonoFill>(recipe.fill);
  const double exponent = bond_step_exponent(recipe.bond_rule, recipe.bond_parameters);
  FloorSaving saving;
  double particles = 0, particles_without = 0, steps = 0, steps_without = 0;  // of equal masses of each rock
  for (const RockTemplate& rock : library.rocks) {
    const double diameter = particle_diameter(fill, rock.diameter), coarser = diameter * fill.ratio / rock.diameter;
    saving.smallest = saving.smallest > 0 ? std::min(saving.smallest, diameter) : diameter;
    saving.largest = std::max(saving.largest, diameter);
    const double count = static_cast<double>(rock.centres.size()) / rock.solid_volume;
    const double count_without = count * coarser * coarser * coarser;
    particles += count;
    particles_without += count_without;
    steps += count / rock.bond_step;
    steps_without += count_without / (rock.bond_step * std::pow(coarser, -exponent));
  }
  if (!(particles > 0)) return saving;
  saving.particles = particles_without / particles;
  // Without bonds the limit is infinite, and nothing is known of steps.
  saving.particle_steps = steps > 0 ? steps_without / steps : saving.particles;
  return saving;
}

}  // namespace gyro
