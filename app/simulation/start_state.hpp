// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"
#include "io/case/case.hpp"

#include <vector>

namespace gyro {

/// Rocks of the case's `particles` and `bonds` files. Bonds get radius and strength as the case's
/// `bonds` say. In a case without bonds every particle is loose.
std::vector<NewRock> start_state(const Case& input);

}  // namespace gyro
