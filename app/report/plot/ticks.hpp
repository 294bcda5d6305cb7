// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace gyro::report {

/// A marked place of an axis.
struct Tick {
  double value;
  std::string label;  ///< empty: a small tick without a label
};

/// A number of an axis with the decimals that the step from tick to tick needs.
std::string tick_label(double value, double step);

/// Ticks at 1, 2 or 5 x 10^k, about `wanted` of them between low and high.
std::vector<Tick> linear_ticks(double low, double high, int wanted = 6);

/// Ticks of a logarithmic axis: labels at 1, 2 and 5 x 10^k over up to two decades, at 10^k over more, at
/// more multiples over less than one; small ticks at
/// the other whole multiples. @param low  > 0
std::vector<Tick> log_ticks(double low, double high);

/// An axis from `low` to `high` in data, drawn from `begin` to `end` [units of the drawing].
struct Scale {
  double low = 0, high = 1, begin = 0, end = 1;
  bool log = false;
  /// Place of a value; values beyond the axis have places beyond its ends.
  double at(double value) const;
};

/// Ends of an axis that holds the values from `low` to `high` with a margin; `low` stays 0 if it is 0. An empty range
/// is widened.
struct Range {
  double low, high;
};
Range widened(Range values, double margin = 0.05);

}  // namespace gyro::report
