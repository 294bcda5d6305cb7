// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/derived.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyro::report {
namespace {

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

Points running_mean(std::span<const double> time, std::span<const double> values, double span) {
  const std::size_t n = std::min(time.size(), values.size());
  std::vector<double> sum(n + 1, 0), rows(n + 1, 0);
  for (std::size_t k = 0; k < n; ++k) {
    const bool known = std::isfinite(values[k]);
    sum[k + 1] = sum[k] + (known ? values[k] : 0);
    rows[k + 1] = rows[k] + (known ? 1 : 0);
  }
  Points means;
  std::size_t first = 0;
  for (std::size_t last = 0; last < n; ++last) {
    while (time[last] - time[first] >= span * (1 - 1e-9)) ++first;
    if (first == 0 && time[last] < span * (1 - 1e-9)) continue;  // the first row begins at 0
    if (rows[last + 1] - rows[first] == 0) continue;
    means.x.push_back(time[last] - span / 2);
    means.y.push_back((sum[last + 1] - sum[first]) / (rows[last + 1] - rows[first]));
  }
  return means;
}

Points by_angle(const Table& series, const Column& column, double begin) {
  const std::vector<double> angle = series.values("eccentric_angle");
  const auto first = static_cast<std::size_t>(std::ranges::upper_bound(series.time(), begin) - series.time().begin());
  const std::size_t rows = angle.size() > first ? angle.size() - first : 0;
  const std::size_t bins = std::clamp<std::size_t>(rows / 6, 12, 72);
  std::vector<double> sum(bins, 0), count(bins, 0);
  for (std::size_t k = std::max<std::size_t>(first, 1); k < angle.size(); ++k) {
    const double value = column.values[k * column.width];
    double at = std::fmod(column.is_mean() ? (angle[k - 1] + angle[k]) / 2 : angle[k], turn);
    if (at < 0) at += turn;
    if (!std::isfinite(value) || !std::isfinite(at)) continue;
    const std::size_t bin = std::min(bins - 1, static_cast<std::size_t>(at / turn * static_cast<double>(bins)));
    sum[bin] += value, ++count[bin];
  }
  Points means;
  for (std::size_t b = 0; b < bins; ++b) {
    if (count[b] == 0) continue;
    means.x.push_back(360 * (static_cast<double>(b) + 0.5) / static_cast<double>(bins));
    means.y.push_back(sum[b] / count[b]);
  }
  return means;
}

std::optional<double> gyration_time(const RunData& run) {
  if (!run.series) return std::nullopt;
  const std::vector<double> angle = run.series->values("eccentric_angle");
  const std::vector<double>& time = run.series->time();
  for (std::size_t k = angle.size(); k-- > 0;)
    if (std::abs(angle.back() - angle[k]) >= turn) return time.back() - time[k];
  return std::nullopt;
}

double last_gyrations(const RunData& run, double count) {
  if (!run.series) return 0;
  const std::vector<double> angle = run.series->values("eccentric_angle");
  const std::vector<double>& time = run.series->time();
  double begin = 0;
  for (std::size_t k = angle.size(); k-- > 0;)
    if (std::abs(angle.back() - angle[k]) >= count * turn) {
      begin = time[k];
      break;
    }
  return run.summary.steady ? std::max(begin, run.begin()) : begin;
}

std::optional<SizeCurve> size_curve(const Sieved& sieved, double begin, const char* column) {
  const Column *passing = sieved.table.find(column), *mass = sieved.table.find("mass");
  if (!passing || !mass || passing->width != sieved.sizes.size() || sieved.table.rows() == 0) return std::nullopt;
  const std::size_t last = sieved.table.rows() - 1, n = passing->width;
  const auto& time = sieved.table.time();
  const auto after = static_cast<std::size_t>(std::ranges::upper_bound(time, begin * (1 + 1e-9)) - time.begin());
  if (begin > 0 && after > last) return std::nullopt;
  SizeCurve curve{sieved.sizes, std::vector<double>(n, 0), mass->values[last]};
  for (std::size_t k = 0; k < n; ++k) curve.passing[k] = passing->values[last * n + k] * mass->values[last];
  if (begin > 0 && after > 0) {
    curve.mass -= mass->values[after - 1];
    for (std::size_t k = 0; k < n; ++k)
      curve.passing[k] -= passing->values[(after - 1) * n + k] * mass->values[after - 1];
  }
  if (!(curve.mass > 0)) return std::nullopt;
  for (double& share : curve.passing) share /= curve.mass;
  return curve;
}

std::optional<SizeCurve> feed_curve(const CaseFacts& facts) {
  constexpr int points = 200;
  if (!facts.feed) return std::nullopt;
  const SizeDistribution law(*facts.feed);
  const double low = law.smallest(), high = law.largest();
  if (!(low > 0) || !(high > low)) return std::nullopt;
  SizeCurve curve;
  for (int k = 0; k <= points; ++k) {
    const double size = low * std::pow(high / low, static_cast<double>(k) / points);
    curve.sizes.push_back(size);
    curve.passing.push_back(k == points ? 1 : law.passing(size));
  }
  return curve;
}

std::optional<double> passing_size(const SizeCurve& curve, double share) {
  for (std::size_t k = 1; k < curve.sizes.size(); ++k) {
    const double low = curve.passing[k - 1], high = curve.passing[k];
    if (low < share && share <= high)
      return curve.sizes[k - 1] * std::pow(curve.sizes[k] / curve.sizes[k - 1], (share - low) / (high - low));
  }
  return std::nullopt;
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& value : values) value *= factor;
  return values;
}

double largest(std::span<const double> values) {
  double most = 0;
  for (const double value : values)
    if (std::isfinite(value)) most = std::max(most, std::abs(value));
  return most;
}

}  // namespace gyro::report
