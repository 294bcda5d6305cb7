// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"

#include <cstdint>
#include <vector>

namespace gyro {

/// Equal spheres of radius 1 in a periodic cube [0, side)^3.
struct Packing {
  double side = 0;
  std::vector<Vec3d> centres;
  double fraction = 0;  ///< volume of the spheres / volume of the cube
  double overlap = 0;   ///< largest overlap of two spheres / radius
};

/// Jams spheres: random points become soft spheres at a packing fraction of 0.632, their elastic energy
/// is minimised (FIRE: Bitzek et al., Phys. Rev. Lett. 97 (2006) 170201), and where an overlap is left
/// above 0.9 % of the radius the cube grows by it. The result depends on the arguments only.
/// @param spheres at least 200, so that no sphere meets itself
Packing jam_spheres(int spheres, std::uint64_t seed);

/// The packing that all rocks are cut from: 2500 spheres, made on first use (0.7 s).
const Packing& rock_packing();

}  // namespace gyro
