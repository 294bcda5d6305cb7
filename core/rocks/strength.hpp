// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

#include <cstdint>

namespace gyro {

/// Normal distribution of the factor on a bond's strengths, cut off at both ends [-]. A deviation
/// of zero gives every bond the mean.
struct StrengthScatter {
  double mean = 1, deviation = 0;
  double lower = 0, upper = 2;
};

/// @throws BadInput unless 0 <= lower <= mean <= upper, lower < upper and deviation >= 0, all finite
void check_scatter(const StrengthScatter& scatter);

/// The factor that the mass fraction p in (0, 1) of the scatter lies below: the inverse of the
/// truncated distribution function, exact to about 1e-14.
double strength_at(const StrengthScatter& scatter, double p);

/// Factor on both strengths of the bond between two particles of a rock. A pure function of its
/// arguments: the same on any device, thread count, restart and order of feeding; i and j may swap.
double strength_factor(const StrengthScatter& scatter, std::uint64_t seed, RockId rock, ParticleId i, ParticleId j);

/// x with P(N(0,1) < x) = p, for p in (0, 1).
double normal_quantile(double p);

}  // namespace gyro
