// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/latin_hypercube.hpp"

#include "core/math/random.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace gyro {
namespace {

// Streams of random numbers are those of the engine; each range has two of its own below `thing`.
constexpr Stream stream = Stream::place;

std::uint64_t stream_of(int number, bool order) {
  return 2 * static_cast<std::uint64_t>(number) + (order ? 1 : 0);
}

/// The numbers 0 to points - 1 in random order (Fisher & Yates).
std::vector<int> shuffled(int points, std::uint64_t seed, int number) {
  std::vector<int> order(static_cast<std::size_t>(points));
  std::iota(order.begin(), order.end(), 0);
  for (int k = points - 1; k > 0; --k) {
    const double u = uniform(seed, stream, stream_of(number, true), static_cast<std::uint32_t>(k));
    const int other = static_cast<int>(u * (k + 1));
    std::swap(order[static_cast<std::size_t>(k)], order[static_cast<std::size_t>(other)]);
  }
  return order;
}

double at_fraction(double fraction, const SampledRange& range) {
  if (range.logarithmic) return range.low * std::pow(range.high / range.low, fraction);
  return range.low + fraction * (range.high - range.low);
}

std::string rounded(double value, int digits) {
  std::array<char, 40> text;
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

}  // namespace

int stratum_of(double value, const SampledRange& range, int points) {
  const double fraction = range.logarithmic ? std::log(value / range.low) / std::log(range.high / range.low)
                                            : (value - range.low) / (range.high - range.low);
  return static_cast<int>(std::floor(fraction * points));
}

std::vector<std::string> latin_hypercube(const SampledRange& range, int points, std::uint64_t seed, int number) {
  constexpr int fewest_digits = 4, all_digits = 17;
  const std::vector<int> strata = shuffled(points, seed, number);
  std::vector<double> values;
  for (std::size_t k = 0; k < strata.size(); ++k) {
    const double u = uniform(seed, stream, stream_of(number, false), static_cast<std::uint32_t>(k));
    values.push_back(at_fraction((strata[k] + u) / points, range));
  }
  for (int digits = fewest_digits;; ++digits) {
    std::vector<std::string> texts;
    bool kept = true;
    for (std::size_t k = 0; k < strata.size(); ++k) {
      texts.push_back(rounded(values[k], digits));
      kept &= stratum_of(std::strtod(texts.back().c_str(), nullptr), range, points) == strata[k];
    }
    if (kept || digits == all_digits) return texts;
  }
}

}  // namespace gyro
