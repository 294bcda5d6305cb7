// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

#include <span>

namespace gyro {

/// Diameter of the sphere of solid rock that has this mass [m]: (6 m / (pi rho))^(1/3).
double equal_mass_diameter(double mass, double rock_density);

/// Side of the smallest square hole that lets a rigid group of spheres through [m].
///
/// The group moves through the hole along a straight line, turned as suits it best: the least,
/// over all its orientations, of the larger of two perpendicular widths. Searched from the
/// principal axes of inertia by a pattern search to 0.05 degrees; a box a >= b >= c of spheres
/// gives b, an ellipsoid sqrt((b^2 + c^2)/2), a long rod its thickness.
double square_mesh_size(std::span<const Vec3d> centres, std::span<const double> radii);

}  // namespace gyro
