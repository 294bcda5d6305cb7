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

/// A shape that the user gives, such as a scan.
struct GivenShape {
  std::string name;     ///< first part of the names of its rocks
  std::string content;  ///< identifies mesh and notes in the recipe's text: equal content gives equal rocks
  /// Returns a closed mesh with outward normals, in any unit, because the size law gives the size. It is called only if
  /// the library is made, not if a cache has it. May throw BadInput.
  std::function<RepairedMesh()> load;
};

struct GivenShapes {
  std::vector<GivenShape> shapes;
  int corners = 0;  ///< of the polyhedron that replaces a scan; 0: the scan itself
};

/// Cylinders of one slenderness, as laboratory specimens.
struct CylinderSpecimen {
  double slenderness = 2;    ///< length / diameter [-]
  double loading_angle = 0;  ///< angle of each of two flats along the side, seen from the axis [rad]; 0: no flats
};

/// Diameter of a cylinder that has the volume of a sphere [m]. @param sphere  diameter of the sphere [m]
double cylinder_diameter(const CylinderSpecimen& specimen, double sphere);

using RockShapes = std::variant<ProceduralShapes, GivenShapes, CylinderSpecimen>;

/// Largest number of rocks and of procedural shapes in a recipe; largest number of corners that replace a scan.
inline constexpr int max_samples = 10000, max_corners = 10000;

/// Everything from which a library is made.
struct LibraryRecipe {
  RockShapes shapes;
  SizeLaw sizes;
  int samples = 24;                ///< number of rocks; each stands for the same share of the feed's mass
  FillRule fill;                   ///< particles of a rock
  double rock_density = 0;         ///< of solid rock [kg/m3]
  bool compensated = true;         ///< particles are denser than rock, so that a rock has the mass of solid rock
  BondRule bond_rule;              ///< which particles are bonded, and the radius of the bonds
  BondParameters bond_parameters;  ///< for the critical step
  BedContacts bed;                 ///< for the critical step
  std::uint64_t seed = 0;
};

/// Told how many rocks of how many are made, from any thread, at any time.
using LibraryProgress = std::function<void(int made, int of)>;

/// Makes a library. Rock k of n has the size that the mass fraction (k + 1/2)/n passes, so a
/// feed that draws rocks with probability proportional to 1/mass follows the size law. Rock k has the shape k modulo
/// the number of shapes. The result is the same for any number of threads.
/// @param threads   that work on it; 0: all cores
/// @param progress  empty, or called after each rock
/// @throws BadInput if the recipe is out of range or a given shape cannot be loaded
RockLibrary make_library(const LibraryRecipe& recipe, int threads = 0, const LibraryProgress& progress = {});

/// Volume of loose, fully crumbled rock / volume of solid rock [-]. It is the packing fraction of the particles in the
/// rocks (mean over the library, whose rocks stand for equal masses) divided by that of a loose bed of spheres, 0.60.
/// Real broken rock has about 1.7. So a bed of single particles occupies too little volume: choking is underestimated
/// and throughput overestimated.
double swell_of_crumbled(const RockLibrary& library);

}  // namespace gyro
