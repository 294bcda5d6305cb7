// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace gyro::report {

/// Values on cells, as colours.
struct HeatMap {
  std::string title, note = {};
  std::string x_label, y_label, value_label;  ///< with units
  std::vector<double> x, y;                   ///< edges of the cells, rising
  std::vector<double> values;                 ///< row after row of y from the lowest; NaN where there is no surface
};

/// Where the colours of a map end: 98 % of the cells above zero lie below, because few cells carry far more than the
/// others and would leave all of them pale.
double end_of_scale(std::vector<double> values);

/// A map with at most so many cells: means over whole cells, of a map with more.
HeatMap coarsened(const HeatMap& map, std::size_t columns = 120, std::size_t rows = 60);

/// The map as an HTML figure.
std::string figure(const HeatMap& map);

}  // namespace gyro::report
