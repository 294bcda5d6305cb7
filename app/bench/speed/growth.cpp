// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/growth.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <string>
#include <utility>

namespace gyro::bench {
namespace {

constexpr int smallest = 1000, usual_largest = 1000000;  // particles, about
constexpr int min_steps = 20, max_steps = 400;           // that are timed
constexpr int warm_up = 20;                              // steps
constexpr double timed_particle_steps = 1e7;

/// Rates of equal scenes with one thread over the present one; 0 if there is none.
double speedup_of(const SpeedResult& result, std::span<const SpeedResult> results) {
  const SpeedMeasurement& m = result.median();
  for (const SpeedResult& one : results)
    if (one.threads == 1 && one.precision == result.precision && one.median().particles == m.particles)
      return result.particle_steps_per_second(m) / one.particle_steps_per_second(one.median());
  return 0;
}

std::set<std::pair<Precision, int>> settings_of(std::span<const GrowthRow> rows) {
  std::set<std::pair<Precision, int>> settings;
  for (const GrowthRow& row : rows) settings.emplace(row.precision, row.threads);
  return settings;
}

}  // namespace

std::vector<SpeedScene> growth_scenes(int largest) {
  std::vector<SpeedScene> scenes;
  for (int particles = smallest; particles <= std::min(largest, usual_largest); particles *= 10) {
    SpeedScene scene = scene_named("S2r");
    scene.recipe.particles = particles;
    scene.warm_up = warm_up;
    scene.timed = std::clamp(static_cast<int>(timed_particle_steps / particles), min_steps, max_steps);
    scenes.push_back(scene);
  }
  return scenes;
}

std::vector<GrowthRow> growth_of(std::span<const SpeedResult> results) {
  std::vector<GrowthRow> rows;
  for (const SpeedResult& r : results) {
    const SpeedMeasurement& m = r.median();
    rows.push_back({.precision = r.precision,
                    .threads = r.threads,
                    .particles = m.particles,
                    .steps = m.steps,
                    .nanoseconds = 1e9 / r.particle_steps_per_second(m),
                    .bytes = static_cast<double>(m.bytes) / static_cast<double>(m.particles),
                    .speedup = speedup_of(r, results),
                    .setup_seconds = m.setup_seconds});
  }
  return rows;
}

double cost_ratio(std::span<const GrowthRow> rows, Precision precision, int threads) {
  double cheapest = 1e300, dearest = 0;
  for (const GrowthRow& row : rows) {
    if (row.precision != precision || row.threads != threads) continue;
    cheapest = std::min(cheapest, row.nanoseconds);
    dearest = std::max(dearest, row.nanoseconds);
  }
  return dearest / cheapest;
}

void print(std::span<const GrowthRow> rows) {
  std::printf("\nRocks of 136 particles between plates (S2r), by the size of the scene\n");
  std::printf("%-8s %8s %10s %7s %18s %10s %10s %9s\n", "", "threads", "particles", "steps", "ns / particle-step",
              "speed-up", "bytes per", "set-up");
  std::printf("%-8s %8s %10s %7s %18s %10s %10s %9s\n", "", "", "", "", "", "", "particle", "s");
  for (const GrowthRow& row : rows)
    std::printf("%-8s %8d %10lld %7lld %18.1f %10.2f %10.0f %9.2f\n", to_string(row.precision).c_str(), row.threads,
                static_cast<long long>(row.particles), static_cast<long long>(row.steps), row.nanoseconds, row.speedup,
                row.bytes, row.setup_seconds);
  for (const auto& [precision, threads] : settings_of(rows))
    std::printf("%s, threads %d: the dearest particle-step costs %.2f times the cheapest\n",
                to_string(precision).c_str(), threads, cost_ratio(rows, precision, threads));
  std::fflush(stdout);
}

nlohmann::ordered_json to_json(std::span<const GrowthRow> rows) {
  nlohmann::ordered_json sizes = nlohmann::ordered_json::array(), ratios = nlohmann::ordered_json::array();
  for (const GrowthRow& row : rows)
    sizes.push_back({{"precision", to_string(row.precision)},
                     {"threads", row.threads},
                     {"particles", row.particles},
                     {"steps", row.steps},
                     {"ns_per_particle_step", row.nanoseconds},
                     {"speedup", row.speedup},
                     {"bytes_per_particle", row.bytes},
                     {"setup_seconds", row.setup_seconds}});
  for (const auto& [precision, threads] : settings_of(rows))
    ratios.push_back({{"precision", to_string(precision)},
                      {"threads", threads},
                      {"cost_ratio", cost_ratio(rows, precision, threads)}});
  return {{"sizes", sizes}, {"cost_ratios", ratios}};
}

}  // namespace gyro::bench
