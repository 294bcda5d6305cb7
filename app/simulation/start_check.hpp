// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/new_rock.hpp"
#include "core/scene/scene.hpp"

#include <span>

namespace gyro {

/// Refuses a start state that would fly apart: contacts that store more energy than those of a settled bed, and
/// particles behind a wall. Particles that a bond joins may overlap. A mesh has no side, so a particle behind one is
/// not detected.
/// @throws BadInput with the pair and its overlap
void check_start(const Scene& scene, std::span<const NewRock> rocks);

}  // namespace gyro
