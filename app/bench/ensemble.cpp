// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/ensemble.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace gyro::bench {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// f(x[k], ref[k]) for all k.
template <class F>
std::vector<double> paired(std::span<const double> x, std::span<const double> ref, F f) {
  std::vector<double> out;
  for (std::size_t k = 0; k < x.size(); ++k) out.push_back(f(x[k], ref[k]));
  return out;
}

double relative(double x, double ref) {
  return x == ref ? 0 : (x - ref) / std::abs(ref);
}
double distance(double x, double ref) {
  return std::abs(relative(x, ref));
}
double differs(double x, double ref) {
  return std::isnan(x) || std::isnan(ref) ? unknown : (x == ref ? 0.0 : 1.0);
}
double difference(double x, double ref) {
  return x - ref;
}
double magnitude(double x, double) {
  return std::abs(x);
}

}  // namespace

Mean mean_of(std::span<const double> sample) {
  Mean mean{0, unknown, 0};
  double sum = 0, squares = 0;
  for (const double x : sample)
    if (!std::isnan(x)) {
      sum += x;
      ++mean.count;
    }
  mean.value = mean.count > 0 ? sum / mean.count : unknown;
  for (const double x : sample)
    if (!std::isnan(x)) squares += (x - mean.value) * (x - mean.value);
  if (mean.count > 1) mean.error = std::sqrt(squares / (mean.count - 1) / mean.count);
  return mean;
}

Deviation deviation(Family family, const Paired& v) {
  const Mean reference = mean_of(v.reference);
  Deviation d;
  d.mean = mean_of(v.measured).value;
  d.reference = reference.value;
  const auto take = [&](auto f) {
    const Mean error = mean_of(paired(v.measured, v.reference, f));
    d.error = error.value;
    d.error_se = error.error;
    d.noise = mean_of(paired(v.coarse, v.reference, f)).value;
    d.seeds = error.count;
  };
  switch (family) {
    case Family::path:
      take(distance);
      d.bias = mean_of(paired(v.measured, v.reference, relative)).value;
      break;
    case Family::identity:
      take(differs);
      break;
    case Family::invariant:
      take(magnitude);
      d.noise = mean_of(paired(v.reference, v.reference, magnitude)).value;
      d.bias = d.mean;
      break;
    case Family::ensemble: {
      const Mean shift = mean_of(paired(v.measured, v.reference, difference));
      const double scale = std::abs(reference.value);
      d.bias = shift.value == 0 ? 0 : shift.value / scale;
      d.error = std::abs(d.bias);
      d.error_se = shift.error == 0 ? 0 : shift.error / scale;
      d.noise = reference.error / scale;
      d.seeds = shift.count;
      break;
    }
  }
  return d;
}

}  // namespace gyro::bench
