// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/plot/line_plot.hpp"
#include "io/run/summary.hpp"

#include <span>

namespace gyro::report {

/// A figure of a run at the value of the parameter that differs from run to run. The error may be NaN: unknown.
struct ParameterPoint {
  double parameter;
  Estimate figure;
};

/// A figure of several runs against a parameter, as points with bars of one standard error joined by a line, for a page
/// that compares the runs of a sweep. Points may come in any order.
/// @param style  of the line, where a plot gets several
Curve parameter_curve(std::string name, std::span<const ParameterPoint> points, int style = 0);

}  // namespace gyro::report
