// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math/vec3.hpp"
#include "core/rocks/soft_spheres.hpp"

#include <cstdint>
#include <vector>

namespace gyro {

/// Spheres in a periodic cube [0, side)^3, or in a vessel of that volume. The smallest has the radius 1.
struct Packing {
  double side = 0;             ///< [smallest radius]
  std::vector<Vec3d> centres;  ///< [smallest radius]
  std::vector<double> radii;   ///< [smallest radius]
  double fraction = 0;         ///< volume of the spheres / volume of the cube
  double overlap = 0;          ///< largest overlap of two spheres / smaller radius
};

/// Jams equal spheres. Random points become soft spheres at a packing fraction of 0.632, and their elastic energy is
/// minimised. If an overlap above 0.9 % of the radius remains, the cube is enlarged to remove it. The result depends on
/// the arguments only.
/// @param spheres  at least 200, so that no sphere touches its own image
Packing jam_spheres(int spheres, std::uint64_t seed);

/// The packing from which all rocks of equal spheres are cut: 2500 spheres, made on first use (0.7 s).
const Packing& rock_packing();

/// Distribution of radii by volume: the share (x^exponent - 1)/(ratio^exponent - 1) of the volume is finer than x.
struct Grading {
  double ratio = 1;       ///< largest radius / smallest radius, at least 1 [-]
  double exponent = 0.8;  ///< [-]
  auto operator<=>(const Grading&) const = default;
};

/// The radius [smallest radius] below which the share u in [0, 1] of the *number* of spheres lies.
double radius_at(const Grading& grading, double u);
/// Mean of radius^3 over the number of spheres [smallest radius^3].
double mean_cubed_radius(const Grading& grading);

/// Jams spheres of many sizes, their radii at even quantiles of the grading. The cube shrinks step by step while the
/// overlaps still relax; then a short-ranged attraction moves spheres without neighbours to the nearest ones, so that
/// all can be bonded. The cube is 5 largest diameters wide.
Packing jam_graded(const Grading& grading, std::uint64_t seed);

/// Jams equal spheres in a vessel that contains the origin and shrinks while the overlaps still relax. So a layer of
/// spheres touches each face, as in a specimen that is made in a mould (Potyondy & Cundall, Int. J. Rock Mech. Min.
/// Sci. 41 (2004) 1329, section 3.1).
/// @param first number of the first sphere in the random stream
Packing jam_in(Vessel vessel, int spheres, std::uint64_t seed, std::uint64_t first);

/// The packing from which rocks of this grading are cut, made once per process. Safe to call from several threads.
const Packing& rock_packing(const Grading& grading);

}  // namespace gyro
