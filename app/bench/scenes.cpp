// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/scenes.hpp"

namespace gyro::bench {
namespace {

const Metric first_break_time{"first_break_time", "s", Family::path};
const Metric first_break_force{"first_break_force", "N", Family::path};
const Metric first_break_bond{"first_break_bond", "1", Family::identity};
const Metric energy_per_mass{"energy_per_mass", "J/kg", Family::ensemble};
const Metric mean_power{"mean_power", "W", Family::ensemble};
const Metric eccentric_speed{"eccentric_speed", "rad/s", Family::ensemble};
const Metric broken_share{"broken_share", "1", Family::ensemble};
const Metric fragment_size{"fragment_size", "m", Family::ensemble};
const Metric p80{"p80", "m", Family::ensemble};
const Metric energy_residual{"energy_residual", "1", Family::invariant};

}  // namespace

std::span<const AccuracyScene> accuracy_scenes() {
  static const std::vector<AccuracyScene> scenes{
      {"platen",
       "R1, one rock between platens",
       "upper",
       {first_break_time, first_break_force, first_break_bond, energy_per_mass, broken_share, fragment_size,
        energy_residual},
       8},
      {"wedge",
       "R2, thirty rocks in a wedge",
       "jaw",
       {first_break_time, first_break_force, first_break_bond, energy_per_mass, broken_share, p80, energy_residual},
       8},
      {"crusher",
       "R3, a sector of a crusher",
       "",
       {first_break_time, first_break_bond, mean_power, eccentric_speed, broken_share, p80, energy_residual},
       8},
  };
  return scenes;
}

}  // namespace gyro::bench
