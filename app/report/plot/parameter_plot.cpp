// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/parameter_plot.hpp"

#include <algorithm>

namespace gyro::report {

Curve parameter_curve(std::string name, std::span<const ParameterPoint> points, int style) {
  std::vector<ParameterPoint> sorted(points.begin(), points.end());
  std::ranges::stable_sort(sorted, {}, &ParameterPoint::parameter);
  Curve curve{.name = std::move(name), .x = {}, .y = {}, .style = style, .points = true};
  for (const ParameterPoint& p : sorted) {
    curve.x.push_back(p.parameter);
    curve.y.push_back(p.figure.value);
    curve.error.push_back(p.figure.error);
  }
  return curve;
}

}  // namespace gyro::report
