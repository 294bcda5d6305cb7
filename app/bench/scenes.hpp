// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/ensemble.hpp"

#include <span>
#include <string>
#include <vector>

namespace gyro::bench {

/// A quantity of a run that is held against the reference.
struct Metric {
  std::string name, unit;
  Family family;
};

/// A reference scene: a case file, what counts in it, and how many strength seeds make its ensemble.
struct AccuracyScene {
  std::string name;  ///< NAME.yaml in the folder of the scenes
  std::string title;
  std::string tool;  ///< wall whose force and work count; empty: the mantle
  std::vector<Metric> metrics;
  int seeds;  ///< 1, 2, ... seeds
};

/// The scenes R1 to R3.
std::span<const AccuracyScene> accuracy_scenes();

}  // namespace gyro::bench
