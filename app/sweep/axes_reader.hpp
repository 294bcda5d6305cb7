// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/sweep/map_reader.hpp"
#include "app/sweep/sweep_file.hpp"

namespace gyro {

constexpr std::int64_t max_points = 100'000;  ///< of a sweep: more is a mistake

/// Reads what varies: `vary`, `together` and `latin_hypercube`, in this order. Values with problems are left out.
std::vector<SweepAxis> read_axes(const YamlNode& root, MapReader& reader);

}  // namespace gyro
