// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace gyro::report {

/// Directions and sizes of a vector as points around a pole, with the mean vector as an arrow.
struct PolarPlot {
  std::string title, note = {};
  std::string label;                    ///< of the size, with its unit
  std::vector<double> along, across;    ///< components in the direction 0 degrees and 90 degrees
  std::vector<std::string> directions;  ///< names at 0, 90, 180 and 270 degrees, counter-clockwise
};

/// The plot as an HTML figure; it draws at most some 1500 of the points, evenly chosen.
std::string figure(const PolarPlot& plot);

}  // namespace gyro::report
