// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"
#include "core/scene/bond_parameters.hpp"
#include "core/scene/load_table.hpp"
#include "core/scene/new_rock.hpp"

#include <memory>

namespace gyro {

/// Bounds on the stresses that loads on single particles cause in the bonds of a rock that they accelerate as a rigid
/// body (inertia relief). A unit load f on particle i gives the rock the acceleration a + alpha x r, and
///
///   K u = f - M (a, alpha)        K of the bonds, M of the particles; solved for each of the six unit loads
///
/// From u follow the responses of the stresses of each bond. The bounds for a load of any direction are, with N, S (2 x
/// 3), B (2 x 3), t the responses of normal stress, shear stress, bending and torsion to three directions
///
///   tension <= |N| + |B|      shear <= |S| + |t|          |.| the largest singular value
///
/// the larger of both. They take compression for tension, and their sums ignore that loads cancel: of a rock pressed on
/// one particle from above and one from below the bound is 7 times the largest ratio.
///
/// Static: waves and damping are left out, and so is the strain by the rock's rotation; rho w^2 d^2 is 2.6 kPa at 1 m
/// and 1 rad/s. So is the friction of MohrCoulomb, which only strengthens bonds.
///
/// Cost: one sparse factorisation and 6 solutions a particle. Memory: 152 bytes a particle and bond, 7.8 MB for 138
/// particles, growing with the square of their number.
LoadTable load_table(const RockTemplate& rock, const BondParameters& bonds);

/// The same, row by row: one factorisation here, 6 solutions a row.
/// @param rock  in one piece, of at least two particles
std::unique_ptr<LoadResponse> load_response(const RockTemplate& rock, const BondParameters& bonds);

/// What the functions above need to know of a rock that was not made from a template, in the frame of its particles.
RockTemplate shape_of(const NewRock& rock);

}  // namespace gyro
