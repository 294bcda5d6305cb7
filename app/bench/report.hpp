// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/bench/accuracy.hpp"

#include <nlohmann/json.hpp>

namespace gyro::bench {

/// Head of a scene's table: title, how the reference was made, its values and its noise.
void print_head(const AccuracyScene& scene, const Reference& reference);
/// A line of the table: cost, and error +- standard error by metric. `~`: within two standard errors of zero.
void print(const Point& point);

/// A point as `bench accuracy --json` gives it, one object for each metric.
void add_json(const Point& point, nlohmann::json& points);

}  // namespace gyro::bench
