// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/speed/speed.hpp"

#include "app/bench/speed/own_process.hpp"
#include "app/bench/speed/state_files.hpp"

#include <algorithm>

namespace gyro::bench {

std::vector<SpeedResult> measure(const SpeedScene& scene, const SpeedPlan& plan) {
  // Made by another process: what this one has used before a fork counts for every run.
  const std::filesystem::path file =
      in_own_process([&] { return write_start(scene, plan.cases, plan.states).string(); }).get<std::string>();
  std::vector<std::string> overrides = scene.make != nullptr ? std::vector<std::string>{} : scene.overrides;
  overrides.insert(overrides.end(), plan.overrides.begin(), plan.overrides.end());
  std::vector<SpeedResult> results;
  for (const int threads : plan.threads)
    for (const Precision precision : plan.precisions) results.push_back({scene.name, threads, precision, {}});
  for (int round = 0; round < plan.repeat; ++round)
    for (SpeedResult& r : results) {
      const SpeedRun run{file, overrides, r.threads, r.precision, scene.warm_up, scene.timed, scene.make == nullptr};
      r.runs.push_back(measurement_of(in_own_process([&] { return to_json(measure_speed(run)); })));
    }
  for (SpeedResult& r : results) std::ranges::sort(r.runs, {}, [&](const SpeedMeasurement& m) { return r.seconds(m); });
  return results;
}

}  // namespace gyro::bench
