// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/speed/measure.hpp"
#include "app/bench/speed/scene.hpp"

#include <functional>
#include <optional>

namespace gyro::bench {

/// What is measured, besides the scene.
struct SpeedPlan {
  std::filesystem::path cases;   ///< folder of the cases
  std::filesystem::path states;  ///< folder of the start states
  std::vector<int> threads = {1, 2};
  std::vector<Precision> precisions = {Precision::mixed, Precision::double_};
  std::vector<std::string> overrides = {};  ///< of all cases
  int repeat = 1;
};

/// The same run, repeated.
struct SpeedResult {
  std::string scene;
  int threads = 1;
  Precision precision = Precision::mixed;
  std::vector<SpeedMeasurement> runs;  ///< by rising time

  /// The run whose time is the median; of an even number the faster of the two in the middle.
  const SpeedMeasurement& median() const { return runs[(runs.size() - 1) / 2]; }
  /// The time that rates are about [s]: of the processor with one thread, which other programs on the machine leave
  /// alone, else of the clock on the wall.
  double seconds(const SpeedMeasurement& run) const { return threads == 1 ? run.cpu_seconds : run.wall_seconds; }
  double particle_steps_per_second(const SpeedMeasurement& run) const {
    return static_cast<double>(run.particles * run.steps) / seconds(run);
  }
};

/// Measures a scene, each run in a process of its own. Repetitions go round: what disturbs the machine for a while
/// disturbs all settings.
std::vector<SpeedResult> measure(const SpeedScene& scene, const SpeedPlan& plan);

}  // namespace gyro::bench
