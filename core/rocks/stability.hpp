// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"
#include "core/scene/scene.hpp"

#include <limits>

namespace gyro {

/// Contacts that every particle may have in a dense bed, in addition to its bonds. A Hertz contact at
/// a fixed overlap/radius has a stiffness proportional to the radius, hence the units.
struct BedContacts {
  double number = 0;                ///< contacts of a particle [-]
  double normal_stiffness = 0;      ///< S_n / R at the stated overlap [N/m per m = Pa]
  double tangential_stiffness = 0;  ///< S_t / R [Pa]
  double normal_damping = 0;        ///< c_n / (2 sqrt(S_n m*)), m* = m/2 [-]
  double tangential_damping = 0;    ///< c_t / (2 sqrt(S_t m*)) [-]
  /// beta: the engine caps the dashpots of contacts so that no eigenvalue of dt M^-1 C_contacts is above it [-]
  double damping_cap = std::numeric_limits<double>::infinity();
};

/// Largest stable step [s] of the leapfrog map v += dt M^-1 (-K x - C v), x += dt v of the rock, linearised
/// at rest, with all bonds intact: the smallest dt at which 4 M - 2 dt C - dt^2 K is singular. The largest mode of
/// M^-1 (dt^2 K + 2 dt C), 6 degrees of freedom a particle, is iterated to a residual of 1e-5, without matrices. The
/// error of the step is below 1e-4, and mostly below 1e-7. Iterated from one random vector, the mode could be one
/// beside the largest; with 120 rocks in two beds, compared with a dense solver, it never was.
///
/// The bed's part of 2 dt C, 2 dt c/m of each degree of freedom, is min(2 dt c/m, 2 damping_cap).
///
/// Bed contacts are assumed isotropic, and the other end of each moves in counterphase, which is an upper bound for any
/// arrangement of contacts: diagonal 2 number (S_n + 2 S_t)/3 for translations and 2 number (2/3) S_t R^2 for
/// rotations, damping alike.
/// @return [s]; infinity if all stiffnesses are zero
double critical_step(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed);

/// The same for a single loose particle [s]. @param radius [m] @param density [kg/m3]
double loose_critical_step(double radius, double density, const BedContacts& bed);

/// Lower bound on critical_step [s] from Gershgorin's row sums: one pass over the bonds of each particle, no iteration.
double gershgorin_step(const RockTemplate& rock, const BondParameters& bonds, const BedContacts& bed);

}  // namespace gyro
