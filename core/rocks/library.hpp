// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/solid.hpp"
#include "core/rocks/bonds.hpp"
#include "core/rocks/fill.hpp"
#include "core/rocks/rock_template.hpp"
#include "core/rocks/size_distribution.hpp"
#include "core/rocks/stability.hpp"
#include "core/scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// Random polyhedra (core/geometry/shapes.hpp).
struct ProceduralShapes {
  int count = 8;
  ShapeStyle style = {};
};

/// A shape from outside, such as a scan.
struct GivenShape {
  std::string name;     ///< with which the rocks' names begin
  std::string content;  ///< identifies mesh and notes in the recipe's text: equal content, equal rocks
  /// Gives a closed mesh with outward normals. Called only if the library is made, not if a cache has it. Its unit does
  /// not matter: the size law gives the size. May throw BadInput.
  std::function<RepairedMesh()> load;
};

struct GivenShapes {
  std::vector<GivenShape> shapes;
  int corners = 0;  ///< of the polyhedron that replaces a scan; 0: the scan itself
};

/// Cylinders of one proportion: specimens of laboratories.
struct CylinderSpecimen {
  double slenderness = 2;    ///< length / diameter [-]
  double loading_angle = 0;  ///< under which the axis sees each of two flats along the side [rad]; 0: none
};

/// Diameter of a cylinder that has the volume of a sphere [m]. @param sphere  diameter of the sphere [m]
double cylinder_diameter(const CylinderSpecimen& specimen, double sphere);

using RockShapes = std::variant<ProceduralShapes, GivenShapes, CylinderSpecimen>;

/// Limits of a recipe: rocks of a library, and procedural shapes; corners that replace a scan.
inline constexpr int max_samples = 10000, max_corners = 10000;

/// What a library is made from.
struct LibraryRecipe {
  RockShapes shapes;
  SizeLaw sizes;
  int samples = 24;                ///< number of rocks; each stands for the same share of the feed's mass
  FillRule fill;                   ///< particles of a rock
  double rock_density = 0;         ///< of solid rock [kg/m3]
  bool compensated = true;         ///< particles are denser than rock, so that a rock has the mass of solid rock
  BondRule bond_rule;              ///< which particles are bonded, and how thick
  BondParameters bond_parameters;  ///< for the critical step
  BedContacts bed;                 ///< for the critical step
  std::uint64_t seed = 0;
};

/// Makes a library. Rock k of n has the size that the mass fraction (k + 1/2)/n passes, so a
/// feed that draws rocks with probability proportional to 1/mass follows the size law. Rock k has the shape k modulo
/// the number of shapes. The result is the same for any number of threads.
/// @param threads  that work on it; 0: all cores
/// @throws BadInput if the recipe is out of range or a given shape cannot be loaded
RockLibrary make_library(const LibraryRecipe& recipe, int threads = 0);

/// Volume of crumbled rock, loose / volume of solid rock [-]: the packing fraction of the particles in the rocks, mean
/// over the library (its rocks stand for equal masses), divided by that of a loose bed of spheres, 0.60. Real broken
/// rock has about 1.7, so a bed of single particles takes too little room: choking and throughput are optimistic.
double swell_of_crumbled(const RockLibrary& library);

}  // namespace gyro
