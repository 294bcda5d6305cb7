// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/verify/scenes.hpp"

// Meshes of the group `mesh`.

namespace gyro::verify {

/// Square [-half, half]^2 at z = 0, split at random points: 2 + 2 x splits triangles, slivers of about 1:1000 among
/// them.
TriangleMesh split_square(double half, int splits);

/// Fan of n coplanar triangles around the origin, of radius 1.
TriangleMesh fan(int n);

/// Two half-planes that meet at x = 0: a valley whose faces enclose `degrees` where the rock is (above 180: a ridge).
TriangleMesh folded(double degrees, double half);

/// Hertz force of a sphere on a rigid wall [N].
double hertz_force(const Material& material, double radius, double overlap);

/// Force on a sphere that nothing moves, held in place for a step [N].
Vec3d force_on_held(const std::vector<Wall>& walls, const Material& material, double radius, const Vec3d& centre,
                    Precision precision);

}  // namespace gyro::verify
