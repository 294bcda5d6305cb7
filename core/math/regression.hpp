// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Host only.

#include <optional>
#include <span>

namespace gyro {

/// Slope of the least-squares line of y on x: sum (x - mean x)(y - mean y) / sum (x - mean x)^2.
/// @param y  of the same length as x  @return nothing if all x are equal
inline std::optional<double> regression_slope(std::span<const double> x, std::span<const double> y) {
  double mean_x = 0, mean_y = 0;
  for (const double value : x) mean_x += value;
  for (const double value : y) mean_y += value;
  mean_x /= static_cast<double>(x.size());
  mean_y /= static_cast<double>(y.size());
  double squares = 0, products = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const double deviation = x[k] - mean_x;
    squares += deviation * deviation;
    products += deviation * (y[k] - mean_y);
  }
  return squares > 0 ? std::optional(products / squares) : std::nullopt;
}

}  // namespace gyro
