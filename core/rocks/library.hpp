// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dem/scene.hpp"
#include "core/rocks/bonds.hpp"
#include "core/rocks/rock_template.hpp"
#include "core/rocks/size_distribution.hpp"
#include "core/rocks/stability.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace gyro {

/// So many random polyhedra (core/geometry/shapes.hpp).
struct ProceduralShapes {
  int count = 8;
};

/// Closed meshes, STL or OBJ; their unit does not matter, the size law gives the size.
struct ShapeFiles {
  std::vector<std::string> paths;
};

/// What a library is made of.
struct LibraryRecipe {
  std::variant<ProceduralShapes, ShapeFiles> shapes;
  SizeLaw sizes;
  int samples = 24;                ///< rocks in the library; each stands for the same share of the feed's mass
  double fill_ratio = 6;           ///< diameter of the rock / diameter of its particles
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

/// $XDG_CACHE_HOME/gyrosim, or $HOME/.cache/gyrosim, or empty if neither is set.
std::string default_cache_folder();

}  // namespace gyro
