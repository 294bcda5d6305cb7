// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/reference.hpp"

#include <functional>
#include <string>
#include <vector>

namespace gyro::bench {

/// A metric of a point with its deviation from the reference.
struct PointMetric {
  Metric metric;
  Deviation deviation;
};

/// One point of the work-precision diagram: cost and error of a setting.
struct Point {
  std::string scene;
  KnobSetting setting;
  int seeds = 0;
  double seconds_per_simulated_second = 0;    ///< processor time of one thread
  double time_step = 0, time_step_limit = 0;  ///< [s]
  std::vector<PointMetric> metrics;
  int stopped = 0;      ///< runs that the guard stopped; the metrics are of the others
  std::string reason;   ///< of the first of these stops
  std::string refused;  ///< reason why a case may not use this setting; empty if it may
};

/// Which part of the bench is run.
struct Extent {
  bool quick = false;  ///< few points, three seeds
  std::string knob;    ///< only this one; empty: all
  int threads = 1;
};

/// Measures the settings of a scene; calls `take` with each point as soon as it is complete.
void measure(const AccuracyScene& scene, const std::filesystem::path& folder, const Reference& reference,
             const Extent& extent, const std::function<void(const Point&)>& take);

}  // namespace gyro::bench
