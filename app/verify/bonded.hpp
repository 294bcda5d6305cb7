// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/scenes.hpp"

#include <optional>

// Bonded rock, as the groups bond to energy use it.

namespace gyro::verify {

/// Of the paper's spheres and bonds (Xiong et al. 2024, Table 1; units as corrected).
inline constexpr double grain = 0.025, bond_radius = 0.005, rock_density = 2600;  // [m], [m], [kg/m3]

/// So dense that no force of a test moves it: its motion is prescribed by its first velocity and spin.
inline constexpr double immovable = 2.6e21;  // [kg/m3]

/// The paper's bonds, undamped.
BondParameters paper_bonds();

/// Stiffnesses of a bond: k_n A, k_s A [N/m], k_n I, k_s J [N m/rad].
struct BondStiffness {
  double normal, shear, bending, torsion;
  explicit BondStiffness(const BondParameters& bonds, double radius = bond_radius);
};

/// Rock with these bonds, walls of steel, no gravity; all pairs alike.
Scene bonded_scene(double dt, const BondParameters& bonds, const PairProperties& pair = {0, 1, 0});

/// n + 1 spheres along x from the origin on, each bonded to the next; the first is immovable if `clamped`.
NewRock chain(RockId id, int n, bool clamped, ParticleId first = 0);

/// n x n x n spheres on a cubic lattice about the origin, neighbours bonded.
NewRock lattice(RockId id, int n, double section, ParticleId first = 0);

/// Random factors between 0.4 and 1.6 on the strengths.
void scatter_strength(NewRock& rock);

/// Number in (-1, 1), the same for the same arguments.
double random_number(std::uint64_t thing, std::uint32_t draw);

/// Quaternion of a rotation vector.
Quatd rotation_by(const Vec3d& rotation);

/// Moves and turns a rock as a whole, velocities too. @param first  added to the ids
NewRock placed(NewRock rock, RockId id, ParticleId first, const Vec3d& to, const Quatd& orientation = {1, 0, 0, 0});

/// Adds a rigid motion about the origin.
void add_rigid_motion(NewRock& rock, const Vec3d& velocity, const Vec3d& angular_velocity);

/// Angular momentum about the origin [kg m2/s].
Vec3d angular_momentum(const ParticleSnapshot& particles);

/// Evenly sampled course of a quantity.
struct Signal {
  double dt;  ///< [s]
  std::vector<double> x;

  /// Mean under the window sin^16, which lets nothing through of a line that has more than nine
  /// periods in the signal.
  double mean() const;
  /// Frequency of the line near a guess, within 1.5/duration [Hz]: the top of its lobe under a Hann window.
  double line_near(double guess) const;
};

}  // namespace gyro::verify
