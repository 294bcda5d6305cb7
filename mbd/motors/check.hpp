// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/errors.hpp"

#include <cmath>
#include <string>

namespace gyro {

/// @throws BadInput unless the value of a motor's parameter is a number > 0
inline void require_positive(double value, const char* parameter) {
  if (std::isfinite(value) && value > 0) return;
  throw BadInput(std::string("motor: ") + parameter + " is " + std::to_string(value) + "; it must be > 0");
}

}  // namespace gyro
