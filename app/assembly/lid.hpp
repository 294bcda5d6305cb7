// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/setup.hpp"

#include <span>

// `crusher.lid`: a wall that closes the space above the rim of the concave, so that no rock leaves over it.

namespace gyro {

/// The wall `lid`: a cylinder that stands on the rim of the concave and is as wide, with a plate on top. It has the
/// material of the concave.
/// @param height  z of the plate [m]
/// @throws BadInput without a concave that is closed around the axis, or for a height that is not above its rim
Wall make_lid(double height, std::span<const Wall> walls);

/// @throws BadKey, with the key to change, if rock appears above the lid at `height`, or if particles are so small that
/// they pass between the lid and the rim of a concave that is not round
void check_lid(double height, const Setup& setup);

}  // namespace gyro
