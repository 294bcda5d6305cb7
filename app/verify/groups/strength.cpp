// SPDX-License-Identifier: GPL-3.0-or-later
// Scatter of bond strength: the truncated normal distribution.
#include "core/rocks/strength.hpp"
#include "app/verify/verification.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyro::verify {
namespace {

const std::string source = "truncated normal, error function";

/// A normal distribution with mean 1 and standard deviation 1 that is truncated at both ends, and its exact properties.
struct Exact {
  std::string name;
  TruncatedNormal scatter;
  double deviation;                              ///< standard deviation of the truncated distribution
  double acceptance;                             ///< share of the normal distribution between the limits
  std::vector<std::array<double, 2>> quantiles;  ///< percent, strength factor
};

void quantiles(Recorder& out) {
  const std::array<Exact, 2> all{
      {{"cut-at-4-and-16-tenths",
        {1, 1, 0.4, 1.6},
        0.338143,
        0.451494,
        {{1, 0.41349}, {10, 0.53063}, {25, 0.71318}, {50, 1}, {75, 1.28682}, {90, 1.46937}, {99, 1.58651}}},
       {"cut-at-2-and-18-tenths",
        {1, 1, 0.2, 1.8},
        0.442386,
        0.576289,
        {{1, 0.21974},
         {10, 0.38563},
         {25, 0.63063},
         {50, 1},
         {75, 2 - 0.63063},
         {90, 2 - 0.38563},
         {99, 2 - 0.21974}}}}};
  for (const Exact& f : all) {
    for (const auto& [percent, factor] : f.quantiles)
      out.absolute(f.name + "-quantile-" + std::to_string(std::lround(percent)), strength_at(f.scatter, percent / 100),
                   factor, {6e-6, 6e-6}, source);
    double squares = 0;
    constexpr int n = 20000;
    for (int k = 0; k < n; ++k) squares += std::pow(strength_at(f.scatter, (k + 0.5) / n) - 1, 2) / n;
    out.relative(f.name + "-deviation", std::sqrt(squares), f.deviation, {3e-6, 3e-6}, source);
    // The density at the median is 1/(sqrt(2 pi) acceptance).
    const double slope = (strength_at(f.scatter, 0.5 + 1e-4) - strength_at(f.scatter, 0.5 - 1e-4)) / 2e-4;
    out.relative(f.name + "-acceptance", slope / std::sqrt(2 * std::numbers::pi), f.acceptance, {3e-6, 3e-6}, source);
  }
}

double distribution(const TruncatedNormal& s, double x) {
  const auto below = [&](double at) { return 0.5 * std::erfc((s.mean - at) / (s.deviation * std::numbers::sqrt2)); };
  return (below(x) - below(s.lower)) / (below(s.upper) - below(s.lower));
}

/// Kolmogorov-Smirnov test of the factors of a million bonds: chains of a thousand particles in a thousand rocks.
void million_bonds(Recorder& out) {
  constexpr int n = 1000000;
  for (const double deviation : {1.0, 0.2}) {
    const TruncatedNormal scatter{1, deviation, 0.4, 1.6};
    std::vector<double> x;
    double product = 0;
    for (int k = 0; k < n; ++k) {
      const auto i = static_cast<ParticleId>(k);
      x.push_back(strength_factor(scatter, 42, k / 1000, i, i + 1));
      if (k > 0) product += (x[x.size() - 1] - 1) * (x[x.size() - 2] - 1);
    }
    double squares = 0;
    for (const double f : x) squares += (f - 1) * (f - 1);
    std::sort(x.begin(), x.end());
    double distance = 0;
    for (int k = 0; k < n; ++k) {
      const double f = distribution(scatter, x[static_cast<std::size_t>(k)]);
      distance = std::max({distance, std::abs(f - k / double{n}), std::abs(f - (k + 1) / double{n})});
    }
    const std::string name = "deviation-" + std::to_string(std::lround(100 * deviation));
    out.within(name + "-distance", distance * std::sqrt(double{n}), 0, 1.628, "Kolmogorov-Smirnov, p = 0.01");
    out.absolute(name + "-correlation-of-neighbours", product / squares, 0, {4e-3, 4e-3}, "independent draws, 4 sigma");
    out.within(name + "-range", x.back() - x.front(), 1.19, 1.2, "within the limits");
  }
}

/// The weakest of 383 bonds: its mean is 0.4 + 1/(383 x density at the lower limit), its standard deviation is 0.0035.
void weakest_bond(Recorder& out) {
  constexpr int rocks = 2000;
  double sum = 0;
  for (int rock = 0; rock < rocks; ++rock) {
    double weakest = 2;
    for (ParticleId i = 0; i < 383; ++i) {
      const auto at = static_cast<ParticleId>(400 * rock) + i;
      weakest = std::min(weakest, strength_factor(TruncatedNormal{1, 1, 0.4, 1.6}, 1, rock, at, at + 1));
    }
    sum += weakest;
  }
  out.absolute("of-383", sum / rocks, 0.40352, {4 * 0.0035 / 44.7, 4 * 0.0035 / 44.7}, "expected minimum, 4 sigma");
}

/// The factor depends only on the seed, the rock and the pair of particles.
void keyed(Recorder& out) {
  const TruncatedNormal s{1, 0.2, 0.4, 1.6};
  const double one = strength_factor(s, 42, 7, 100, 200);
  out.absolute("ends-swapped", strength_factor(s, 42, 7, 200, 100) - one, 0, {0, 0}, "the same bond");
  double same = 0;
  same += strength_factor(s, 43, 7, 100, 200) == one;
  same += strength_factor(s, 42, 8, 100, 200) == one;
  same += strength_factor(s, 42, 7, 100, 201) == one;
  same += strength_factor(s, 42 + (std::uint64_t{1} << 32), 7, 100, 200) == one;
  out.absolute("others-that-agree", same, 0, {0, 0}, "another seed, rock or bond");
  out.absolute("no-scatter", strength_factor(TruncatedNormal{1.1, 0, 0.4, 1.6}, 42, 7, 100, 200), 1.1, {0, 0},
               "the mean");
}

}  // namespace

std::vector<Verification> strength_cases() {
  return {
      {"strength/quantiles", quantiles, Precisions::double_only},
      {"strength/million-bonds", million_bonds, Precisions::double_only},
      {"strength/weakest-bond", weakest_bond, Precisions::double_only},
      {"strength/keyed", keyed, Precisions::double_only},
  };
}

}  // namespace gyro::verify
