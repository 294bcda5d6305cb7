// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace gyro {

/// Number type of the loads. Positions, orientations and velocities are double in both.
enum class Precision {
  mixed,   ///< loads in single precision
  double_  ///< loads in double precision
};

/// The word for a precision in case files, results and messages.
inline std::string to_string(Precision precision) {
  return precision == Precision::mixed ? "mixed" : "double";
}

}  // namespace gyro
