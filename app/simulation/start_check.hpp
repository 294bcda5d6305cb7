// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"

#include <span>

namespace gyro {

/// Refuses a start state that would fly apart: contacts whose stored energy is more than a settled bed has,
/// and particles behind a wall. What bonds hold together may overlap. Meshes have no side: behind one nothing is seen.
/// @throws BadInput with the pair and its overlap
void check_start(const Scene& scene, std::span<const NewRock> rocks);

}  // namespace gyro
