// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

namespace gyro {

/// A length for a message. @param length  [m]
inline std::string in_mm(double length) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4g mm", 1e3 * length);
  return text;
}

}  // namespace gyro
