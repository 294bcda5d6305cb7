// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/speed/speed.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <vector>

namespace gyro::bench {

/// S2r with 1000, 10,000, 100,000 and 1,000,000 particles, about, as far as `largest`. All begin with the same steps;
/// the larger the scene, the fewer are timed.
std::vector<SpeedScene> growth_scenes(int largest = 1000000);

/// What a particle costs in a scene of some size.
struct GrowthRow {
  Precision precision;
  int threads;
  std::int64_t particles, steps;
  double nanoseconds;    ///< of a particle-step, by SpeedResult::seconds()
  double bytes;          ///< of a particle at the peak, set-up included
  double speedup;        ///< over one thread; 0 where one thread was not measured
  double setup_seconds;  ///< wall time
};
/// @param results  of scenes of several sizes
std::vector<GrowthRow> growth_of(std::span<const SpeedResult> results);

/// The largest cost of a particle-step with so many threads over the smallest.
double cost_ratio(std::span<const GrowthRow> rows, Precision precision, int threads);

void print(std::span<const GrowthRow> rows);
nlohmann::ordered_json to_json(std::span<const GrowthRow> rows);

}  // namespace gyro::bench
