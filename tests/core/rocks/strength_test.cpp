// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/strength.hpp"
#include "core/base/errors.hpp"
#include "core/math/random.hpp"
#include "tests/catch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace gyro;

namespace {

double normal_cdf(double x) {
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

}  // namespace

TEST_CASE("The normal quantile inverts the distribution function to rounding") {
  for (double x = -8; x <= 6; x += 0.0625) {
    const double p = normal_cdf(x);
    // Above the median, p next to 1 has lost digits itself.
    const double lost = 1e-15 / std::exp(-x * x / 2) * (x > 0 ? 1 : 0);
    CHECK(std::abs(normal_quantile(p) - x) < 4e-14 + 4 * lost);
  }
  CHECK(normal_quantile(0.975) == Approx(1.959963984540054).epsilon(1e-14));
}

TEST_CASE("A scatter that does not define a distribution is refused") {
  CHECK_NOTHROW(check_scatter(TruncatedNormal{1, 0.2, 0.4, 1.6}));
  for (const TruncatedNormal& s :
       {TruncatedNormal{1, -0.1, 0.4, 1.6}, TruncatedNormal{1, 0.1, 1.6, 0.4}, TruncatedNormal{1, 0.1, -0.1, 1.6},
        TruncatedNormal{2, 0.1, 0.4, 1.6}, TruncatedNormal{1, 0.1, 1, 1}, TruncatedNormal{1, NAN, 0.4, 1.6}}) {
    CHECK_THROWS_AS(check_scatter(s), BadInput);
  }
}

TEST_CASE("The paper's literal scatter is a standard normal about 1, redrawn outside the range") {
  const StrengthScatter scatter = paper_literal(0.4, 1.6);
  // Rejection, as equation 8 suggests; the same distribution by another method.
  std::vector<double> redrawn, drawn;
  for (std::uint32_t k = 0; redrawn.size() < 100000; ++k) {
    const double factor = 1 + normal_quantile(uniform(7, Stream::strength, k, 0));
    if (factor >= 0.4 && factor <= 1.6) redrawn.push_back(factor);
  }
  for (ParticleId k = 0; k < 100000; ++k) drawn.push_back(strength_factor(scatter, 8, 0, k, k + 1));
  std::sort(redrawn.begin(), redrawn.end());
  std::sort(drawn.begin(), drawn.end());
  double distance = 0;
  for (std::size_t a = 0, b = 0; a < drawn.size() && b < redrawn.size();) {
    drawn[a] < redrawn[b] ? ++a : ++b;
    distance = std::max(distance, std::abs(static_cast<double>(a) - static_cast<double>(b)) / 1e5);
  }
  CHECK(distance < 1.628 * std::sqrt(2e-5));  // two-sample Kolmogorov-Smirnov, p = 0.01
  CHECK(distance > 0);
}

TEST_CASE("Weibull strengths follow their distribution and have their mean") {
  const WeibullStrength weibull = GENERATE(WeibullStrength{1, 5}, WeibullStrength{0.8, 1.5});
  constexpr int n = 200000;
  std::vector<double> x;
  double sum = 0, squares = 0;
  for (ParticleId k = 0; k < n; ++k) {
    x.push_back(strength_factor(weibull, 42, 3, k, k + 1));
    sum += x.back(), squares += x.back() * x.back();
  }
  std::sort(x.begin(), x.end());
  const double scale = weibull.mean / std::tgamma(1 + 1 / weibull.modulus);
  double distance = 0;
  for (int k = 0; k < n; ++k) {
    const double f = 1 - std::exp(-std::pow(x[k] / scale, weibull.modulus));
    distance = std::max({distance, std::abs(f - k / double{n}), std::abs(f - (k + 1) / double{n})});
  }
  CHECK(distance * std::sqrt(double{n}) < 1.628);  // Kolmogorov-Smirnov, p = 0.01
  const double mean = sum / n, deviation = std::sqrt(squares / n - mean * mean);
  CHECK(std::abs(mean - weibull.mean) < 4 * deviation / std::sqrt(double{n}));
  // Size effect: the weakest of a hundred is 100^(-1/m) as strong.
  CHECK(strength_at(weibull, 1 - std::pow(1 - 0.5, 0.01)) / strength_at(weibull, 0.5) ==
        Approx(std::pow(100, -1 / weibull.modulus)));
  CHECK_THROWS_AS(check_scatter(WeibullStrength{1, 0}), BadInput);
  CHECK_THROWS_AS(check_scatter(WeibullStrength{-1, 3}), BadInput);
}
