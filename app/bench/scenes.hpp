// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/ensemble.hpp"

#include <span>
#include <string>
#include <vector>

namespace gyro::bench {

/// A quantity of a run that is compared with the reference.
struct Metric {
  std::string name, unit;
  Family family;
};

/// A reference scene: a case file, its metrics, and the number of strength seeds of its ensemble.
struct AccuracyScene {
  std::string name;  ///< NAME.yaml in the folder of the scenes
  std::string title;
  std::string tool;  ///< wall whose force and work are measured; empty: the mantle
  std::vector<Metric> metrics;
  int seeds;  ///< number of seeds 1, 2, ...
};

/// The scenes R1 to R3.
std::span<const AccuracyScene> accuracy_scenes();

}  // namespace gyro::bench
