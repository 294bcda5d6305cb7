// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/dem.hpp"

#include <span>

namespace gyro::bench {

/// Sizes of the fragments of a scene; the size of a fragment is the diameter of a sphere of equal volume.
struct Sizes {
  double mass = 0;  ///< of all [kg]
  double mean = 0;  ///< weighted by mass [m]
  double p80 = 0;   ///< size that 80 % of the mass passes [m]
};

/// @param density  of the particles [kg/m3]
Sizes sizes_of(const ParticleSnapshot& particles, double density);

/// Size that a share of the mass passes: linear between the middles of the fragments' shares, so that it is continuous
/// when a fragment grows. Before the first and after the last middle it is the smallest and the largest size.
/// @pre sizes and masses are equally long, not empty
double passing_size(std::span<const double> sizes, std::span<const double> masses, double share);

}  // namespace gyro::bench
