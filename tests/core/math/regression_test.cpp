// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/math/regression.hpp"
#include "app/verify/fixtures/random.hpp"
#include "tests/catch.hpp"

#include <vector>

using namespace gyro;
using namespace gyro::fixtures;

TEST_CASE("The regression line of points on a line has its slope", "[math]") {
  std::vector<double> x, y;
  for (std::uint64_t k = 0; k < 50; ++k) {
    x.push_back(1e-3 * random_number(k, 0));
    y.push_back(7 - 2e9 * x.back());
  }
  CHECK(regression_slope(x, y).value() == Approx(-2e9).epsilon(1e-12));
}

TEST_CASE("The regression line minimises the sum of squared residuals", "[math]") {
  std::vector<double> x, y;
  for (std::uint64_t k = 0; k < 200; ++k) {
    x.push_back(random_number(k, 0));
    y.push_back(3 * x.back() + random_number(k, 1));
  }
  // The best offset to any slope is the mean of y - slope x.
  const auto squares = [&](double slope) {
    double mean = 0, sum = 0;
    for (std::size_t k = 0; k < x.size(); ++k) mean += (y[k] - slope * x[k]) / 200;
    for (std::size_t k = 0; k < x.size(); ++k) sum += (y[k] - slope * x[k] - mean) * (y[k] - slope * x[k] - mean);
    return sum;
  };
  const double slope = regression_slope(x, y).value();
  CHECK(slope == Approx(3).margin(0.3));
  for (const double change : {-1e-3, 1e-3}) CHECK(squares(slope + change) > squares(slope));
}

TEST_CASE("Points with equal abscissae have no regression slope", "[math]") {
  CHECK_FALSE(regression_slope(std::vector<double>{2, 2, 2}, std::vector<double>{1, 2, 3}));
}
