// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/saved_state.hpp"
#include "core/feed/filling.hpp"
#include "core/scene/scene.hpp"
#include "io/case/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace gyro {

// feed.initial_from: the chamber is filled from the checkpoint of another run.

/// The fragments of a saved run that have not left its chamber, in the order of their first particles.
/// @param angle  about z by which positions and velocities are turned [rad]
/// @throws BadInput for the state of a run without a crusher
std::vector<SourceFragment> hold_up_of(const SavedState& state, double angle);

/// The filling of a case that has feed.initial_from, and its line for the log.
/// @param scene  with walls
/// @param start  rocks whose numbers and ids are already in use
/// @throws BadInput for a source that cannot be used
struct FillingOfCase {
  ChamberFilling filling;
  std::string note;
};
FillingOfCase filling_of(const Case& input, const Scene& scene, const RockLibrary& library,
                         std::span<const NewRock> start);

}  // namespace gyro
