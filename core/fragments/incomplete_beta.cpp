// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fragments/incomplete_beta.hpp"

#include "core/base/expect.hpp"

#include <cmath>
#include <initializer_list>

namespace gyro {
namespace {

/// 1/(1 + d1/(1 + d2/(1 + ...))) of the incomplete beta function.
double continued_fraction(double x, double a, double b) {
  constexpr int max_terms = 500;
  constexpr double tiny = 1e-300, enough = 1e-16;
  const auto no_zero = [](double v) { return std::abs(v) < tiny ? tiny : v; };
  double numerator = 1, denominator = 1 / no_zero(1 - (a + b) / (a + 1) * x), value = denominator;
  for (int m = 1; m <= max_terms; ++m) {
    const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
    const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
    double step = 1;
    for (const double d : {even, odd}) {
      denominator = 1 / no_zero(1 + d * denominator);
      numerator = no_zero(1 + d / numerator);
      step = numerator * denominator;
      value *= step;
    }
    if (std::abs(step - 1) < enough) break;
  }
  return value;
}

/// x^a (1-x)^b / (a B(a, b)) times the continued fraction.
double by_fraction(double x, double a, double b) {
  const double log_beta = std::lgamma(a) + std::lgamma(b) - std::lgamma(a + b);
  return std::exp(a * std::log(x) + b * std::log1p(-x) - log_beta) / a * continued_fraction(x, a, b);
}

}  // namespace

double incomplete_beta(double x, double a, double b) {
  GYRO_EXPECT(x >= 0 && x <= 1 && a > 0 && b > 0);
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  return x <= (a + 1) / (a + b + 2) ? by_fraction(x, a, b) : 1 - by_fraction(1 - x, b, a);
}

}  // namespace gyro
