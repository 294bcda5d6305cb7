// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rocks/bonds.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/rock_template.hpp"
#include "core/rocks/size_distribution.hpp"
#include "core/rocks/stability.hpp"
#include "core/scene/scene.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// So many random polyhedra (core/geometry/shapes.hpp).
struct ProceduralShapes {
  int count = 8;
  ShapeStyle style = {};
};

/// Closed meshes, STL or OBJ; their unit does not matter, the size law gives the size.
struct ShapeFiles {
  std::vector<std::string> paths;
  int corners = 0;  ///< of the polyhedron that stands for a scan; 0: the scan itself
};

/// Cylinders of one proportion, length / diameter: specimens of laboratories.
struct CylinderSpecimen {
  double slenderness = 2;
  double loading_angle = 0;  ///< under which the axis sees each of two flats along the side [rad]; 0: none
};

/// Diameter of a cylinder that has the volume of a sphere [m]. @param sphere its diameter [m]
double cylinder_diameter(const CylinderSpecimen& specimen, double sphere);

/// What a library is made of.
struct LibraryRecipe {
  std::variant<ProceduralShapes, ShapeFiles, CylinderSpecimen> shapes;
  SizeLaw sizes;
  int samples = 24;                ///< rocks in the library; each stands for the same share of the feed's mass
  FillRule fill;                   ///< particles of a rock
  double rock_density = 0;         ///< of solid rock [kg/m3]
  bool compensated = true;         ///< particles are denser than rock, so that the rock weighs what solid rock weighs
  BondRule bond_rule;              ///< who is bonded, and how thick
  BondParameters bond_parameters;  ///< for the critical step
  BedContacts bed;                 ///< for the critical step
  std::uint64_t seed = 0;
};

/// Makes a library, or reads it from `cache_folder` where the same recipe (contents of shape files
/// included) was made before. Rock k of n has the size that the mass fraction (k + 1/2)/n passes, so a
/// feed that draws rocks with probability proportional to 1/mass follows the size law. Shapes are
/// dealt in turn. The same for any number of threads. A cache file that cannot be read or written
/// costs time and nothing else.
/// @param cache_folder empty: no cache
/// @throws BadInput recipe out of range, or shape files that are no rocks
RockLibrary make_library(const LibraryRecipe& recipe, const std::string& cache_folder);

/// Loose volume of crumbled rock / volume of solid rock: packing fraction of the particles in the rocks, mean over the
/// library, whose rocks stand for equal masses, over that of a loose bed of spheres, 0.60. Real broken
/// rock comes to about 1.7, so a bed of single particles takes too little room: choking and throughput are optimistic.
double swell_of_crumbled(const RockLibrary& library);

/// $XDG_CACHE_HOME/gyrosim, or $HOME/.cache/gyrosim, or empty if neither is set.
std::string default_cache_folder();

}  // namespace gyro
