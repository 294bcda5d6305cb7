// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/rock_template.hpp"

#include <variant>

namespace gyro {

/// Bond radius = factor x smaller particle radius.
struct RelativeBondRadius {
  double factor = 0.5;
};

/// The same bond radius everywhere, also where it is larger than a particle's [m].
struct AbsoluteBondRadius {
  double radius = 0;
};

/// Section of the bond = factor x pi R_h^2, R_h = 2 Ri Rj/(Ri + Rj) the harmonic mean radius: the area of a Hertz
/// contact goes as R_h, at an overlap that goes as R_h, hence as R_h^2. Between equal spheres R_b = sqrt(factor) R.
struct ContactAreaBond {
  double factor = 0.25;
};

/// Which neighbours are bonded, and how thick the bonds are.
struct BondRule {
  double gap = 0.05;  ///< bonded if (distance of surfaces) < gap x smaller radius [-]
  std::variant<RelativeBondRadius, AbsoluteBondRadius, ContactAreaBond> radius;
};

/// @throws BadInput gap negative or not below 1, bond radius not positive
void check_rule(const BondRule& rule);

/// Radius of the bond between particles of radii ri and rj [m].
double bond_radius(const BondRule& rule, double ri, double rj);

/// The bonds of a set of spheres, sorted by (i, j).
std::vector<TemplateBond> make_bonds(const std::vector<Vec3d>& centres, const std::vector<double>& radii,
                                     const BondRule& rule);

/// Sorts bonds by colour, then (i, j), so that inside a colour no two share a particle. Each bond takes,
/// in (i, j) order, the first colour free at both ends: at most 2 z - 1 colours for z bonds a particle.
/// @return first bond of each colour, and the number of bonds at the end
std::vector<Index> colour_bonds(std::vector<TemplateBond>& bonds, Index particles);

/// Particles of the largest connected set, ascending; of equally large sets the one with the lowest particle.
std::vector<Index> largest_piece(const std::vector<TemplateBond>& bonds, Index particles);

}  // namespace gyro
