// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/strength.hpp"

#include "core/base/errors.hpp"
#include "core/math/random.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro {
namespace {

/// P(N(0,1) < x), without cancellation in the lower tail.
double normal_distribution(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

/// Rational approximation of the quantile for p <= 1/2, relative error 1.15e-9.
/// P. J. Acklam, "An algorithm for computing the inverse normal cumulative distribution function" (2003).
double acklam(double p) {
  if (p < 0.02425) {
    const double q = std::sqrt(-2 * std::log(p));
    return (((((-7.784894002430293e-03 * q - 3.223964580411365e-01) * q - 2.400758277161838e+00) * q -
              2.549732539343734e+00) *
                 q +
             4.374664141464968e+00) *
                q +
            2.938163982698783e+00) /
           ((((7.784695709041462e-03 * q + 3.224671290700398e-01) * q + 2.445134137142996e+00) * q +
             3.754408661907416e+00) *
                q +
            1);
  }
  const double q = p - 0.5, r = q * q;
  return (((((-3.969683028665376e+01 * r + 2.209460984245205e+02) * r - 2.759285104469687e+02) * r +
            1.383577518672690e+02) *
               r -
           3.066479806614716e+01) *
              r +
          2.506628277459239e+00) *
         q /
         (((((-5.447609879822406e+01 * r + 1.615858368580409e+02) * r - 1.556989798598866e+02) * r +
            6.680131188771972e+01) *
               r -
           1.328068155288572e+01) *
              r +
          1);
}

}  // namespace

double normal_quantile(double p) {
  if (p > 0.5) return -normal_quantile(1 - p);
  const double x = acklam(p);
  if (!(p > 1e-300)) return x;
  // One Halley step reduces the error from 1e-9 to rounding.
  const double miss = (normal_distribution(x) - p) * std::sqrt(2 * std::numbers::pi) * std::exp(x * x / 2);
  return x - miss / (1 + x * miss / 2);
}

namespace {

void check(const TruncatedNormal& s) {
  const bool finite =
      std::isfinite(s.mean) && std::isfinite(s.deviation) && std::isfinite(s.lower) && std::isfinite(s.upper);
  if (!finite || !(s.deviation >= 0))
    throw BadInput("strength scatter: deviation must be >= 0, and all numbers finite");
  if (!(s.lower >= 0 && s.lower <= s.mean && s.mean <= s.upper && s.lower < s.upper)) {
    throw BadInput("strength scatter: range must be [lower, upper] with 0 <= lower <= mean <= upper, lower < upper");
  }
}

void check(const WeibullStrength& s) {
  if (!(std::isfinite(s.mean) && s.mean > 0 && std::isfinite(s.modulus) && s.modulus > 0))
    throw BadInput("strength scatter: mean and modulus of a Weibull distribution must be finite and > 0");
}

double quantile(const TruncatedNormal& s, double p) {
  if (s.deviation == 0) return s.mean;
  const double low = normal_distribution((s.lower - s.mean) / s.deviation);
  const double high = normal_distribution((s.upper - s.mean) / s.deviation);
  const double x = s.mean + s.deviation * normal_quantile(low + p * (high - low));
  return std::clamp(x, s.lower, s.upper);  // corrects rounding only
}

double quantile(const WeibullStrength& s, double p) {
  return s.mean / std::tgamma(1 + 1 / s.modulus) * std::pow(-std::log1p(-p), 1 / s.modulus);
}

}  // namespace

void check_scatter(const StrengthScatter& scatter) {
  std::visit([](const auto& s) { check(s); }, scatter);
}

double strength_at(const StrengthScatter& scatter, double p) {
  return std::visit([&](const auto& s) { return quantile(s, p); }, scatter);
}

double strength_factor(const StrengthScatter& s, std::uint64_t seed, RockId rock, ParticleId i, ParticleId j) {
  const auto [low, high] = std::minmax(i, j);
  const std::uint64_t bond = (std::uint64_t{high} << 32) | low;
  return strength_at(s, uniform(seed, Stream::strength, bond, static_cast<std::uint32_t>(rock)));
}

}  // namespace gyro
