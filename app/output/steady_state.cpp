// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/output/steady_state.hpp"

#include "core/fragments/sieve_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro {
namespace {

using Gyrations = std::span<const GyrationMeans>;

template <class Get>
double mean(Gyrations g, const Get& get) {
  double sum = 0;
  for (const GyrationMeans& one : g) sum += get(one);
  return sum / static_cast<double>(g.size());
}

double holdup_of(const GyrationMeans& m) {
  return m.holdup;
}
double duration_of(const GyrationMeans& m) {
  return m.end - m.begin;
}

/// Change of the least-squares line through a quantity, from the first to the last gyration.
template <class Get>
double drift(Gyrations g, const Get& get) {
  const double middle = (static_cast<double>(g.size()) - 1) / 2;
  const double average = mean(g, get);
  double across = 0, square = 0;
  for (std::size_t k = 0; k < g.size(); ++k) {
    const double x = static_cast<double>(k) - middle;
    across += x * (get(g[k]) - average);
    square += x * x;
  }
  return across / square * 2 * middle;
}

template <class Get>
bool drifts(Gyrations g, const Get& get, double limit) {
  return std::abs(drift(g, get)) > limit * std::abs(mean(g, get));
}

/// Square of the standard error of the mean power [W2].
double error2(Gyrations g, double average) {
  const double variance = mean(g, [&](const GyrationMeans& m) { return (m.power - average) * (m.power - average); });
  return variance / std::max(1.0, static_cast<double>(g.size()) - 1);
}

bool is_steady(Gyrations g, const SteadyLimits& limits) {
  if (drifts(g, holdup_of, limits.holdup_drift) || drifts(g, duration_of, limits.speed_drift)) return false;
  const auto power = [](const GyrationMeans& m) { return m.power; };
  const Gyrations first = g.first(g.size() / 2), second = g.last(g.size() / 2);
  const double a = mean(first, power), b = mean(second, power);
  const double noise = 2 * std::sqrt(error2(first, a) + error2(second, b));
  return std::abs(b - a) <= std::max(limits.power_change * std::abs(mean(g, power)), noise);
}

/// Sums over the gyrations of a block, or of several.
struct Sums {
  double gyrations = 0, time = 0;       ///< time [s]
  double power = 0, motor_power = 0;    ///< sums of the gyrations' means [W]
  double energy = 0;                    ///< crushing [J]
  double discharged = 0;                ///< [kg]
  std::vector<double> sieve_mass = {};  ///< discharged, by sieve [kg]

  void add(const Sums& other) {
    gyrations += other.gyrations;
    time += other.time;
    power += other.power;
    motor_power += other.motor_power;
    energy += other.energy;
    discharged += other.discharged;
    sieve_mass.resize(other.sieve_mass.size());
    for (std::size_t k = 0; k < sieve_mass.size(); ++k) sieve_mass[k] += other.sieve_mass[k];
  }
};

Sums sums_of(const GyrationMeans& g, std::span<const double> sieve_mass) {
  const double time = g.end - g.begin;
  return {1, time, g.power, g.motor_power, g.power * time, g.discharged, {sieve_mass.begin(), sieve_mass.end()}};
}

/// The gyrations from number `first` on, in blocks with nearly equal numbers of gyrations.
std::vector<Sums> blocks_of(const GyrationRecord& record, std::size_t first) {
  constexpr std::size_t most = 10, shortest = 2;
  const std::size_t count = record.gyrations.size() - first;
  const std::size_t sieves = record.sieve_mass.size() / record.gyrations.size();
  std::vector<Sums> blocks(std::clamp(count / shortest, std::size_t{1}, most));
  for (std::size_t k = 0; k < count; ++k)
    blocks[k * blocks.size() / count].add(
        sums_of(record.gyrations[first + k], std::span(record.sieve_mass).subspan((first + k) * sieves, sieves)));
  return blocks;
}

Sums all_but(const std::vector<Sums>& blocks, std::size_t left_out) {
  Sums sums;
  for (std::size_t k = 0; k < blocks.size(); ++k)
    if (k != left_out) sums.add(blocks[k]);
  return sums;
}

/// Jackknife over blocks. @param figure  std::optional<double> of Sums
template <class Figure>
std::optional<Estimate> estimate(const std::vector<Sums>& blocks, const Figure& figure) {
  const std::optional<double> value = figure(all_but(blocks, blocks.size()));
  if (!value) return std::nullopt;
  const auto count = static_cast<double>(blocks.size());
  std::vector<double> parts;
  double average = 0, squares = 0;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    parts.push_back(figure(all_but(blocks, k)).value_or(std::numeric_limits<double>::quiet_NaN()));
    average += parts.back() / count;
  }
  for (const double part : parts) squares += (part - average) * (part - average);
  return Estimate{*value, std::sqrt((count - 1) / count * squares)};
}

ProductRow curve_of(const Sums& sums, const std::vector<double>& sieves) {
  SieveTally tally{sums.sieve_mass};
  for (const double mass : tally.sieve_mass) tally.mass += mass;
  return tally.row(sieves, 0);
}

SteadyState describe(const GyrationRecord& record, std::size_t first, std::span<const double> sizes,
                     const std::vector<double>& sieves) {
  const Gyrations g = Gyrations(record.gyrations).subspan(first);
  const std::vector<Sums> blocks = blocks_of(record, first);
  const auto number = [&](const auto& figure) {
    return estimate(blocks, [&](const Sums& s) { return std::optional<double>(figure(s)); }).value_or(Estimate{});
  };
  SteadyState s;
  s.from = g.front().begin;
  s.gyrations = g.size();
  s.blocks = blocks.size();
  s.power = number([](const Sums& b) { return b.power / b.gyrations; });
  s.motor_power = number([](const Sums& b) { return b.motor_power / b.gyrations; });
  s.throughput = number([](const Sums& b) { return b.discharged / b.time; });
  s.specific_energy = estimate(
      blocks, [](const Sums& b) { return b.discharged > 0 ? std::optional(b.energy / b.discharged) : std::nullopt; });
  s.p80 = estimate(blocks, [&](const Sums& b) { return curve_of(b, sieves).p80; });
  s.p50 = estimate(blocks, [&](const Sums& b) { return curve_of(b, sieves).p50; });
  for (const double size : sizes)
    s.below.push_back(estimate(blocks, [&](const Sums& b) {
      const ProductRow curve = curve_of(b, sieves);
      return curve.mass > 0 ? passing_at(sieves, curve.passing, size) : std::nullopt;
    }));
  if (s.throughput.value > 0) s.residence_time = mean(g, holdup_of) / s.throughput.value;
  return s;
}

std::size_t fewest(const SteadyLimits& limits) {
  return std::max<std::size_t>(limits.min_gyrations, 2);
}

}  // namespace

std::optional<SteadyState> steady_state(const GyrationRecord& record, std::span<const double> sizes,
                                        const SteadyLimits& limits, const std::vector<double>& sieves) {
  const Gyrations all(record.gyrations);
  for (std::size_t k = 0; k + fewest(limits) <= all.size(); ++k)
    if (is_steady(all.subspan(k), limits)) return describe(record, k, sizes, sieves);
  return std::nullopt;
}

std::string unsteady_reason(const GyrationRecord& record, const SteadyLimits& limits) {
  const Gyrations all(record.gyrations);
  if (all.size() < fewest(limits))
    return "the run is too short: " + std::to_string(all.size()) + (all.size() == 1 ? " gyration" : " gyrations") +
           ", at least " + std::to_string(fewest(limits)) + " are needed";
  const Gyrations end = all.last(fewest(limits));
  if (drifts(end, holdup_of, limits.holdup_drift))
    return drift(end, holdup_of) > 0 ? "the chamber is still filling" : "the chamber is emptying";
  if (drifts(end, duration_of, limits.speed_drift)) return "the speed of the drive still changes";
  return "the crushing power still changes";
}

}  // namespace gyro
