// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <span>
#include <vector>

namespace gyro::bench {

/// Two spheres, i < j.
struct ClosePair {
  Index i, j;
};

/// All pairs of spheres whose surfaces are closer than `gap` [m], ordered by (i, j). The work is proportional to their
/// number, so that a million spheres take seconds.
std::vector<ClosePair> close_pairs(std::span<const Vec3d> centres, std::span<const double> radii, double gap);

/// Smallest (distance of centres)/(sum of radii) of spheres that are near each other; infinity where none are. Below 1
/// spheres overlap.
double smallest_room(std::span<const Vec3d> centres, std::span<const double> radii);

}  // namespace gyro::bench
