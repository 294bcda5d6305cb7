// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"

#include <variant>

namespace gyro {

/// Bond radius = factor x smaller particle radius.
struct RelativeBondRadius {
  double factor = 0.5;  ///< [-]
};

/// The same radius for all bonds; it may be larger than that of the particles.
struct AbsoluteBondRadius {
  double radius = 0;  ///< [m]
};

/// Section of the bond = factor x pi R_h^2, R_h = 2 Ri Rj/(Ri + Rj) the harmonic mean radius: the area of a Hertz
/// contact is proportional to R_h x overlap, hence to R_h^2 if the overlap is proportional to R_h. Between equal
/// spheres R_b = sqrt(factor) R.
struct ContactAreaBond {
  double factor = 0.25;  ///< [-]
};

/// Which neighbours are bonded, and the radius of the bonds.
struct BondRule {
  double gap = 0.05;  ///< bonded if (distance of surfaces) < gap x smaller radius [-]
  std::variant<RelativeBondRadius, AbsoluteBondRadius, ContactAreaBond> radius;
};

/// @throws BadInput if the gap is not in [0, 1) or the bond radius is not above 0
void check_rule(const BondRule& rule);

/// Radius of the bond between particles of radii ri and rj [m].
double bond_radius(const BondRule& rule, double ri, double rj);

/// The bonds of a set of spheres, sorted by (i, j).
/// @param centres, radii  of the same number of spheres [m]
std::vector<TemplateBond> make_bonds(const std::vector<Vec3d>& centres, const std::vector<double>& radii,
                                     const BondRule& rule);

/// Sorts bonds by colour, then (i, j). Two bonds of one colour share no particle. In (i, j) order each bond gets
/// the first colour free at both ends: at most 2 z - 1 colours for z bonds a particle.
/// @return first bond of each colour, and as the last entry the number of bonds
std::vector<Index> colour_bonds(std::vector<TemplateBond>& bonds, Index particles);

/// Particles of the largest connected set, ascending; if several are equally large, the set with the lowest particle.
std::vector<Index> largest_piece(const std::vector<TemplateBond>& bonds, Index particles);

}  // namespace gyro
