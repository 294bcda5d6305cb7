// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/hd.hpp"

#include <cstdint>
#include <variant>

namespace gyro {

/// Normal distribution of the factor on a bond's strengths, cut off at both ends [-]. A deviation
/// of zero gives every bond the mean.
struct TruncatedNormal {
  double mean = 1, deviation = 0;
  double lower = 0, upper = 2;
};

/// The distribution as printed in the reference paper (Xiong et al., Minerals 14 (2024) 774, eq. 8): strength S_c (N +
/// 1) with N standard normal; values outside the range are drawn again. Nearly uniform over 0.4 to 1.6, which contains
/// 45 % of the draws.
inline TruncatedNormal paper_literal(double lower, double upper) {
  return {1, 1, lower, upper};
}

/// Weibull distribution of the factor: P(factor < x) = 1 - exp(-(x/s)^modulus), s = mean/Gamma(1 + 1/modulus).
struct WeibullStrength {
  double mean = 1;
  double modulus = 5;  ///< 3 to 8 for rocks [-]
};

using StrengthScatter = std::variant<TruncatedNormal, WeibullStrength>;

/// @throws BadInput unless 0 <= lower <= mean <= upper, lower < upper and deviation >= 0, all finite; for a Weibull
/// distribution unless mean and modulus are > 0
void check_scatter(const StrengthScatter& scatter);

/// The factor below which the share p in (0, 1) of the bonds lies: the inverse of the distribution
/// function, for the truncated normal exact to about 1e-14.
double strength_at(const StrengthScatter& scatter, double p);

/// Factor on both strengths of the bond between two particles of a rock. A pure function of its arguments: the same on
/// any device, for any number of threads, after a restart and in any order of feeding; i and j may be exchanged.
double strength_factor(const StrengthScatter& scatter, std::uint64_t seed, RockId rock, ParticleId i, ParticleId j);

/// x with P(N(0,1) < x) = p, for p in (0, 1).
double normal_quantile(double p);

}  // namespace gyro
