// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rocks/strength.hpp"
#include "core/base/errors.hpp"
#include "tests/catch.hpp"

#include <cmath>

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

TEST_CASE("A scatter that is no distribution is refused") {
  CHECK_NOTHROW(check_scatter({1, 0.2, 0.4, 1.6}));
  for (const StrengthScatter& s :
       {StrengthScatter{1, -0.1, 0.4, 1.6}, StrengthScatter{1, 0.1, 1.6, 0.4}, StrengthScatter{1, 0.1, -0.1, 1.6},
        StrengthScatter{2, 0.1, 0.4, 1.6}, StrengthScatter{1, 0.1, 1, 1}, StrengthScatter{1, NAN, 0.4, 1.6}}) {
    CHECK_THROWS_AS(check_scatter(s), BadInput);
  }
}
