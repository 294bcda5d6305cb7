// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/library.hpp"

namespace gyro {

/// What a floor of particle sizes saves, beside the same rocks filled with the ratio alone. Estimated from the library
/// that was made: with s the ratio of a rock's particle diameters with and without the floor, it would have s^3 times
/// as many particles, and steps shorter by s^-p (bond_step_exponent()).
struct FloorSaving {
  double smallest = 0, largest = 0;  ///< particle diameters in the library [m]
  double particles = 1;              ///< particles of a mass of feed without the floor / with it [-]
  double particle_steps = 1;         ///< steps of these particles at the limits of their bonds, likewise [-]
};

/// Exponent p in: stability limit of a rock's bonds ~ (particle diameter D)^p, from sqrt(mass / stiffness) with mass ~
/// D^3 and stiffness ~ bond radius^2 (a stiffness per area is given) or ~ bond radius^2 / D (a modulus is given). Bond
/// radius ~ D, or the same for all bonds.
double bond_step_exponent(const BondRule& rule, const BondParameters& parameters);

/// @param recipe  of the library; its fill must be a MonoFill
FloorSaving floor_saving(const LibraryRecipe& recipe, const RockLibrary& library);

}  // namespace gyro
