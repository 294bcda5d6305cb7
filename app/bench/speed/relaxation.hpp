// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"
#include "core/math/vec3.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace gyro::bench {

/// The nearest place for a sphere of this radius inside a domain.
using Confine = std::function<Vec3d(const Vec3d& centre, double radius)>;

/// A box, and the part of it in which lattice points may lie.
struct Domain {
  Vec3d low, high;  ///< [m]
  std::function<bool(const Vec3d&)> inside;
};

/// Points of a cubic lattice in a domain, the widest that has `count` of them, each moved by up to 0.3 of its spacing
/// along each axis.
std::vector<Vec3d> jittered_lattice(int count, const Domain& domain, std::uint64_t seed);

/// Moves spheres apart until no overlap exceeds 1e-4 of the sum of two radii, or 800 steps are done.
///
/// All have the same mass and repel each other with their overlap (a little more than that, so that they part); FIRE
/// (core/rocks/soft_spheres.hpp) minimises, and what leaves the domain is put back. SoftSpheres is not used because its
/// containers are convex, and those of S2 and S3 are round.
void separate(std::vector<Vec3d>& centres, const std::vector<double>& radii, const Confine& confine);

}  // namespace gyro::bench
