// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/simulation/setup.hpp"

#include <optional>
#include <string>

namespace gyro {

/// Sizes of the particles of rock that can break, the smallest pieces that exist, as the product counts them:
/// equal-mass diameters [m]. No fragment is finer than its coarsest particle, so that the product below `coarsest` is
/// incomplete, and below `finest` there is none; what real rock has there is unknown.
struct Resolution {
  double coarsest = 0, finest = 0;
};

/// Resolution of the rock of a setup: of its start, and of all templates that its feed draws from, also those that no
/// rock has been made of yet, so that it is known at the start. None without rock that can break.
std::optional<Resolution> resolution_of(const Setup& setup);

/// "5.2 mm", or "3.1 to 8.3 mm".
std::string to_string(const Resolution& resolution);

}  // namespace gyro
