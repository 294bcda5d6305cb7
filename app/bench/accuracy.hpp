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

/// One point of the work-precision diagram: what a setting costs and how far off it is.
struct Point {
  std::string scene;
  KnobSetting setting;
  int seeds = 0;
  double seconds_per_simulated_second = 0;  ///< processor time of one thread
  double time_step = 0, time_step_limit = 0;
  std::vector<PointMetric> metrics;
  int stopped = 0;      ///< runs that the guard stopped; the metrics are of the others
  std::string reason;   ///< of the first of them
  std::string refused;  ///< why a case may not ask for this setting; empty if it may
};

/// What of the bench is run.
struct Extent {
  bool quick = false;
  std::string knob;  ///< only this one; empty: all
  int threads = 1;
};

/// Measures the settings of a scene, each handed over as soon as it is there.
void measure(const AccuracyScene& scene, const std::filesystem::path& folder, const Reference& reference,
             const Extent& extent, const std::function<void(const Point&)>& take);

}  // namespace gyro::bench
