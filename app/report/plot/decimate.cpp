// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/decimate.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace gyro::report {
namespace {

/// The points of a stretch that are kept.
std::set<std::size_t> kept(std::span<const double> y, std::size_t begin, std::size_t end) {
  std::set<std::size_t> points;
  std::size_t low = end, high = end, broken = end;
  for (std::size_t k = begin; k < end; ++k) {
    if (!std::isfinite(y[k])) {
      broken = k;
      continue;
    }
    if (low == end || y[k] < y[low]) low = k;
    if (high == end || y[k] > y[high]) high = k;
  }
  for (const std::size_t point : {low, high, broken})
    if (point != end) points.insert(point);
  return points;
}

}  // namespace

std::vector<std::size_t> decimated(std::span<const double> y, std::size_t limit) {
  std::vector<std::size_t> points;
  if (y.size() <= limit) {
    points.resize(y.size());
    std::iota(points.begin(), points.end(), std::size_t{0});
    return points;
  }
  const bool broken = std::ranges::any_of(y, [](double v) { return !std::isfinite(v); });
  const std::size_t stretches = (limit - 2) / (broken ? 3 : 2), inner = y.size() - 2;
  points.push_back(0);
  for (std::size_t s = 0; s < stretches; ++s)
    for (const std::size_t point : kept(y, 1 + inner * s / stretches, 1 + inner * (s + 1) / stretches))
      points.push_back(point);
  points.push_back(y.size() - 1);
  return points;
}

}  // namespace gyro::report
