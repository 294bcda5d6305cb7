// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro {

/// Dampers of the bed at a step dt: each has a share (weight) of a motion, and dt c is capped.
struct BedDamping {
  double uncapped = 0;  ///< sum of weight c over dampers below the cap
  double capped = 0;    ///< sum of weight over the others

  void add(double weight, double c, double dt, double cap) {
    if (dt * c > cap) {
      capped += weight;
    } else {
      uncapped += weight * c;
    }
  }
};

/// Smallest dt > 0 with dt^2 a + 2 dt b = rest; infinity if there is none.
inline double uncapped_step(double a, double b, double rest) {
  const double sum = b + std::sqrt(b * b + a * rest);
  return sum > 0 ? rest / sum : std::numeric_limits<double>::infinity();
}

/// The dt > 0 with dt^2 a + 2 dt b + sum of weight min(2 dt c, 2 cap) = 4, for a motion of weight 1. Without the cap dt
/// would be smaller. From there dt grows while dampers reach the cap; dampers that have reached it stay there, so that
/// it ends.
/// @param damping  a function of dt that returns BedDamping
template <class Damping>
double capped_step(double a, double b, double cap, const Damping& damping) {
  double dt = uncapped_step(a, b + damping(0).uncapped, 4);
  for (bool grows = std::isfinite(dt) && std::isfinite(cap); grows;) {
    const BedDamping bed = damping(dt);
    const double next = uncapped_step(a, b + bed.uncapped, 4 - 2 * cap * bed.capped);
    grows = next > dt && std::isfinite(next);
    dt = std::max(dt, next);
  }
  return dt;
}

}  // namespace gyro
