// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/feed/feed.hpp"
#include "core/rocks/library.hpp"
#include "io/case/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace gyro {

// The rock of a case: bonds, library, start state and feed.

/// Strength of the bonds of a case; empty if all are equally strong.
BondStrength bond_strength(const Case& input);

/// Recipe of the library. @param scene  with materials, pairs and bonds
LibraryRecipe library_recipe(const Case& input, const Scene& scene);

/// What the floor of particle sizes changes, for `check`, `library` and log; empty without a floor.
std::vector<std::string> floor_notes(const LibraryRecipe& recipe, const RockLibrary& library);

/// Rocks of the case's `particles` and `bonds` files. Bonds get radius and strength as the case's `bonds` say. In a
/// case without bonds every particle is loose.
std::vector<NewRock> start_state(const Case& input);

/// Depth below the discharge plane at which a fragment can no longer touch anything: twice the extent of the largest
/// rock [m].
double removal_depth(const RockLibrary& library, std::span<const NewRock> start);

/// The feed of a case that has one.
/// @param scene   with walls
/// @param start   rocks whose numbers and ids are already in use
/// @throws BadInput for a wall that cannot bound a region
FeedPlan feed_plan(const Case& input, const Scene& scene, const RockLibrary& library, std::span<const NewRock> start);

}  // namespace gyro
