// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/triangle_mesh.hpp"

#include <cstdint>

namespace gyro {

/// Roughens a convex solid around the origin: 1280 triangles whose corners lie on the solid's surface, moved along
/// the radius by the factor exp(roughness x noise). The noise has mean 0 and standard deviation 1 over rocks: three
/// octaves of plane waves of random direction and phase. The first has 1 wave over the rock; each octave has half the
/// amplitude of the one before.
/// The result is star-shaped, so it cannot intersect itself.
/// @param roughness     standard deviation of the logarithm of the radius [-]
/// @param seed, number  of the rock; its draws begin at `first_draw` of the stream
TriangleMesh roughened(const TriangleMesh& convex, double roughness, std::uint64_t seed, std::uint64_t number,
                       std::uint32_t first_draw);

}  // namespace gyro
