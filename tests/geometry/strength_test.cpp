// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/strength.hpp"
#include "core/base/errors.hpp"
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

TEST_CASE("Quantiles of the truncated normal are the reference values") {
  // Truncated normal with mean 1 and deviation 1, from the error function with mpmath.
  const StrengthScatter narrow{1, 1, 0.4, 1.6}, wide{1, 1, 0.2, 1.8};
  const std::vector<std::pair<double, double>> narrow_reference{
      {0.01, 0.41349}, {0.10, 0.53063}, {0.25, 0.71318}, {0.5, 1}, {0.75, 1.28682}, {0.90, 1.46937}, {0.99, 1.58651}};
  for (const auto& [p, x] : narrow_reference) CHECK(std::abs(strength_at(narrow, p) - x) < 6e-6);
  for (const auto& [p, x] : std::vector<std::pair<double, double>>{{0.01, 0.21974}, {0.10, 0.38563}, {0.25, 0.63063}}) {
    CHECK(std::abs(strength_at(wide, p) - x) < 6e-6);
  }
}

TEST_CASE("A million bonds follow the truncated normal") {
  const StrengthScatter scatter = GENERATE(StrengthScatter{1, 1, 0.4, 1.6}, StrengthScatter{1, 0.2, 0.4, 1.6});
  constexpr int n = 1000000;
  std::vector<double> x;
  double sum = 0, squares = 0;
  for (int k = 0; k < n; ++k) {  // chains of 1000 particles in 1000 rocks
    const ParticleId i = static_cast<ParticleId>(k);
    x.push_back(strength_factor(scatter, 42, k / 1000, i, i + 1));
    sum += x.back();
    squares += (x.back() - 1) * (x.back() - 1);
  }
  std::sort(x.begin(), x.end());
  const auto z = [&](double s) { return (s - scatter.mean) / scatter.deviation; };
  const double low = normal_cdf(z(scatter.lower)), whole = normal_cdf(z(scatter.upper)) - low;
  double distance = 0;
  for (int k = 0; k < n; ++k) {
    const double f = (normal_cdf(z(x[k])) - low) / whole;
    distance = std::max({distance, std::abs(f - k / double{n}), std::abs(f - (k + 1) / double{n})});
  }
  CHECK(distance * std::sqrt(double{n}) < 1.628);  // Kolmogorov-Smirnov, p = 0.01
  CHECK(std::abs(sum / n - 1) < 4 * scatter.deviation / std::sqrt(double{n}));
  if (scatter.deviation == 1) CHECK(std::sqrt(squares / n) == Approx(0.338143).epsilon(3e-3));
  CHECK(x.front() >= scatter.lower);
  CHECK(x.back() <= scatter.upper);
}

TEST_CASE("The weakest of 383 bonds has the expected strength") {
  const StrengthScatter scatter{1, 1, 0.4, 1.6};
  constexpr int rocks = 2000;
  double sum = 0;
  for (int rock = 0; rock < rocks; ++rock) {
    double weakest = 2;
    for (ParticleId i = 0; i < 383; ++i) {
      weakest = std::min(weakest, strength_factor(scatter, 1, rock, 400 * rock + i, 400 * rock + i + 1));
    }
    sum += weakest;
  }
  // 0.4 + 1/(383 x density at the lower end); the minimum scatters by 0.0035.
  CHECK(std::abs(sum / rocks - 0.40352) < 4 * 0.0035 / std::sqrt(double{rocks}));
}

TEST_CASE("The strength of a bond is a pure function of who it joins") {
  const StrengthScatter scatter{1, 0.2, 0.4, 1.6};
  const double s = strength_factor(scatter, 42, 7, 100, 200);
  CHECK(strength_factor(scatter, 42, 7, 200, 100) == s);
  CHECK(strength_factor(scatter, 43, 7, 100, 200) != s);
  CHECK(strength_factor(scatter, 42, 8, 100, 200) != s);
  CHECK(strength_factor(scatter, 42, 7, 100, 201) != s);
  CHECK(strength_factor({1.1, 0, 0.4, 1.6}, 42, 7, 100, 200) == 1.1);
}

TEST_CASE("A scatter that is no distribution is refused") {
  CHECK_NOTHROW(check_scatter({1, 0.2, 0.4, 1.6}));
  for (const StrengthScatter& s :
       {StrengthScatter{1, -0.1, 0.4, 1.6}, StrengthScatter{1, 0.1, 1.6, 0.4}, StrengthScatter{1, 0.1, -0.1, 1.6},
        StrengthScatter{2, 0.1, 0.4, 1.6}, StrengthScatter{1, 0.1, 1, 1}, StrengthScatter{1, NAN, 0.4, 1.6}}) {
    CHECK_THROWS_AS(check_scatter(s), BadInput);
  }
}
