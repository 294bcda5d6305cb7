// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/time_step.hpp"
#include "core/dem/make_dem.hpp"
#include "core/feed/feed.hpp"
#include "core/rocks/library.hpp"
#include "core/scene/dem.hpp"
#include "core/walls/liners.hpp"
#include "core/walls/mesh_chamber.hpp"
#include "io/case/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gyro {

/// A wall as a snapshot draws it.
struct WallPicture {
  TriangleMesh mesh;  ///< body frame
  Index wall;
};

/// Everything that a run of a case needs, made from the case before the first step.
struct Assembly {
  Scene scene;
  RockLibrary library;
  std::optional<Liners> liners;  ///< of a crusher given by its profile
  std::vector<NewRock> start;    ///< the start state of `particles`
  std::optional<FeedPlan> feed;
  StepChoice step;
  Index gyrating = none;     ///< the first wall that the eccentric moves
  double pivot_height = 0;   ///< [m]
  double removal_depth = 0;  ///< below the discharge plane [m]
  std::vector<WallPicture> pictures;
  std::vector<std::string> notes;  ///< what was done to input files, for the log
};

/// Makes scene, library, liners, feed plan and time step of a case.
/// @throws BadKey for files that cannot be used, a library that cannot be made, a step above its limit
Assembly assemble(const Case& input);

/// Materials and walls alone, the mantle set. @throws BadKey as assemble() does
Assembly assemble_walls(const Case& input);

/// Mantle and concave of a scene where both are meshes: the first wall that gyrates, and the fixed one of that name.
std::optional<MeshLiners> mesh_liners(const Scene& scene);

/// Liners of a crusher with a profile. @throws BadInput for settings that the profile cannot have
Liners liners_of(const CaseCrusher& crusher);

/// Strength of the bonds of a case.
BondStrength bond_strength(const Case& input);

}  // namespace gyro
