// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/motor_rows.hpp"

#include <algorithm>
#include <cmath>

namespace gyro {

void MotorRows::add(double length, double power) {
  state_.length += length;
  state_.work += power * length;
}

void MotorRows::end_row(double time) {
  if (!(state_.length > 0)) return;
  state_.end.push_back(time);
  state_.power.push_back(state_.work / state_.length);
  state_.length = state_.work = 0;
}

std::optional<MotorFigures> MotorRows::figures(double from, std::optional<double> rated_power) const {
  std::vector<double> powers;
  double work = 0, time = 0, begin = 0;  // begin: of the row [s]
  for (std::size_t k = 0; k < state_.end.size(); begin = state_.end[k++]) {
    const double length = state_.end[k] - begin;
    if (begin < from - 1e-6 * length) continue;
    powers.push_back(state_.power[k]);
    work += state_.power[k] * length;
    time += length;
  }
  if (powers.empty()) return std::nullopt;
  std::sort(powers.begin(), powers.end());
  MotorFigures f;
  f.from = from;
  f.mean = work / time;
  const double rank = std::ceil(0.95 * static_cast<double>(powers.size()));  // nearest rank
  f.p95 = powers[static_cast<std::size_t>(rank) - 1];
  f.peak = powers.back();
  if (rated_power) {
    f.rated_power = rated_power;
    f.mean_fraction = f.mean / *rated_power;
    f.peak_fraction = f.peak / *rated_power;
  }
  return f;
}

}  // namespace gyro
