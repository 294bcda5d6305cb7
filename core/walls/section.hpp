// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/scene.hpp"

#include <vector>

namespace gyro {

/// Points of a section through the crusher's axis, joined by straight lines.
using Polyline = std::vector<ProfilePoint>;

/// The part of a polyline of increasing z up to a height [m]; at least two points if the line begins below it.
Polyline below(const Polyline& line, double z);

/// Shortest distance of two polylines that do not cross [m].
double distance_between(const Polyline& a, const Polyline& b);

/// True when a piece of one line crosses a piece of the other.
bool cross_each_other(const Polyline& a, const Polyline& b);

}  // namespace gyro
