// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/steady_state.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace gyro {
namespace {

using Gyrations = std::span<const GyrationMeans>;

template <class Get>
double mean(Gyrations g, const Get& get) {
  double sum = 0;
  for (const GyrationMeans& one : g) sum += get(one);
  return sum / static_cast<double>(g.size());
}

/// Change of the least-squares line through hold-up, from the first to the last gyration [kg].
double holdup_drift(Gyrations g) {
  const double middle = (static_cast<double>(g.size()) - 1) / 2;
  const double average = mean(g, [](const GyrationMeans& m) { return m.holdup; });
  double across = 0, square = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double x = static_cast<double>(k) - middle;
    across += x * (g[k].holdup - average);
    square += x * x;
  }
  return across / square * 2 * middle;
}

/// Square of the standard error of the mean power [W2].
double error2(Gyrations g, double average) {
  const double variance = mean(g, [&](const GyrationMeans& m) { return (m.power - average) * (m.power - average); });
  return variance / std::max(1.0, static_cast<double>(g.size()) - 1);
}

bool is_steady(Gyrations g, const SteadyLimits& limits) {
  const double holdup = mean(g, [](const GyrationMeans& m) { return m.holdup; });
  if (std::abs(holdup_drift(g)) > limits.holdup_drift * std::abs(holdup)) return false;
  const auto power = [](const GyrationMeans& m) { return m.power; };
  const Gyrations first = g.first(g.size() / 2), second = g.last(g.size() / 2);
  const double a = mean(first, power), b = mean(second, power);
  const double noise = 2 * std::sqrt(error2(first, a) + error2(second, b));
  return std::abs(b - a) <= std::max(limits.power_change * std::abs(mean(g, power)), noise);
}

SteadyState describe(Gyrations g) {
  SteadyState s;
  s.from = g.front().begin;
  s.power = mean(g, [](const GyrationMeans& m) { return m.power; });
  const double discharged =
      static_cast<double>(g.size()) * mean(g, [](const GyrationMeans& m) { return m.discharged; });
  s.throughput = discharged / (g.back().end - g.front().begin);
  if (s.throughput > 0) s.residence_time = mean(g, [](const GyrationMeans& m) { return m.holdup; }) / s.throughput;
  return s;
}

}  // namespace

std::optional<SteadyState> steady_state(const std::vector<GyrationMeans>& gyrations, const SteadyLimits& limits) {
  const Gyrations all(gyrations);
  for (std::size_t k = 0; k + std::max<std::size_t>(limits.min_gyrations, 2) <= all.size(); ++k)
    if (is_steady(all.subspan(k), limits)) return describe(all.subspan(k));
  return std::nullopt;
}

void GyrationReader::add(double time, double length, double angle, double power, double holdup, double discharged) {
  State& s = state_;
  if (s.length == 0) s.begin = time - length;
  s.length += length;
  s.power += power * length;
  s.holdup += holdup * length;
  const double turns = std::floor(std::abs(angle) / (2 * std::numbers::pi));
  if (turns <= s.turns) return;
  s.done.push_back({s.begin, time, s.power / s.length, s.holdup / s.length, discharged - s.discharged});
  s = {.done = std::move(s.done), .turns = turns, .discharged = discharged};
}

}  // namespace gyro
