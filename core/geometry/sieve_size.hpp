// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/mesh.hpp"

namespace gyro {

/// Side of the smallest square opening that lets the convex hull of the points through, straight
/// and without turning on the way: over all directions of passage, the smallest square around
/// the hull's shadow. Found by search, from above, to about 0.1 % (a 2 x 3 x 5 block: 3; an
/// ellipsoid with semi-axes a > b > c: 2 sqrt((b^2 + c^2)/2), turned into the diagonal).
double sieve_size(const std::vector<Vec3d>& points);

/// Smallest square around a shadow, seen along a unit direction.
double shadow_square(const std::vector<Vec3d>& points, const Vec3d& direction);

}  // namespace gyro
