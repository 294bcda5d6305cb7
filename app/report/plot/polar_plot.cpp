// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/polar_plot.hpp"

#include "app/report/plot/svg.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>

namespace gyro::report {
namespace {

constexpr double width = 560, height = 400, middle_x = width / 2, middle_y = 208, radius = 160;
constexpr std::size_t limit = 1500;

std::string circle(const std::string& css, double x, double y, double r) {
  return "<circle class=\"" + css + "\"" + attribute("cx", x) + attribute("cy", y) + attribute("r", r) + "/>";
}

std::string svg_rings(const Scale& scale) {
  std::string svg;
  for (const Tick& t : linear_ticks(0, scale.high, 4)) {
    if (t.value <= 0) continue;
    svg += circle("ring", middle_x, middle_y, scale.at(t.value)) +
           svg_text(middle_x + scale.at(t.value) * 0.71 + 2, middle_y + scale.at(t.value) * 0.71, t.label, "start");
  }
  return svg + svg_line(middle_x - radius, middle_y, middle_x + radius, middle_y, "grid") +
         svg_line(middle_x, middle_y - radius, middle_x, middle_y + radius, "grid");
}

std::string svg_directions(const std::vector<std::string>& names) {
  if (names.size() != 4) return "";
  return svg_text(middle_x + radius + 8, middle_y, names[0], "start", "middle") +
         svg_text(middle_x, middle_y - radius - 8, names[1], "middle") +
         svg_text(middle_x - radius - 8, middle_y, names[2], "end", "middle") + "<g class=\"down\">" +
         svg_text(middle_x, middle_y + radius + 8, names[3], "middle") + "</g>";
}

std::string svg_arrow(double x, double y) {
  constexpr double head = 11, half_width = 5;
  const double length = std::hypot(x, y);
  if (!(length > head)) return circle("dot c1", middle_x + x, middle_y + y, 5);
  const double ux = x / length, uy = y / length, bx = x - head * ux, by = y - head * uy;
  const auto point = [](double px, double py) { return place(middle_x + px) + " " + place(middle_y + py); };
  return svg_line(middle_x, middle_y, middle_x + bx, middle_y + by, "arrow c1") + "<path class=\"dot c1\" d=\"M" +
         point(x, y) + "L" + point(bx - half_width * uy, by + half_width * ux) + "L" +
         point(bx + half_width * uy, by - half_width * ux) + "Z\"/>";
}

}  // namespace

std::string figure(const PolarPlot& plot) {
  double largest = 0, along = 0, across = 0, points = 0;
  for (std::size_t k = 0; k < plot.along.size(); ++k) {
    if (!std::isfinite(plot.along[k]) || !std::isfinite(plot.across[k])) continue;
    largest = std::max(largest, std::hypot(plot.along[k], plot.across[k]));
    along += plot.along[k], across += plot.across[k], ++points;
  }
  const Scale scale{0, largest > 0 ? 1.02 * largest : 1, 0, radius};
  std::string svg = svg_rings(scale) + svg_directions(plot.directions) + svg_text(2, 14, plot.label, "start", "label");
  const std::size_t stride = std::max<std::size_t>(1, (plot.along.size() + limit - 1) / limit);
  for (std::size_t k = 0; k < plot.along.size(); k += stride)
    if (std::isfinite(plot.along[k]) && std::isfinite(plot.across[k]))
      svg += circle("dot c0 faint", middle_x + scale.at(plot.along[k]), middle_y - scale.at(plot.across[k]), 1.8);
  if (points > 0) svg += svg_arrow(scale.at(along / points), -scale.at(across / points));
  const std::string legend =
      "<li><svg viewBox=\"0 0 30 12\" class=\"sample\" aria-hidden=\"true\">" + std::string() +
      "<circle class=\"dot c0\" cx=\"15\" cy=\"6\" r=\"2.5\"/></svg>each row of the run</li>"
      "<li><svg viewBox=\"0 0 30 12\" class=\"sample\" aria-hidden=\"true\"><line class=\"arrow c1\" x1=\"0\" y1=\"6\" "
      "x2=\"20\" y2=\"6\"/><path class=\"dot c1\" d=\"M30 6L19 1L19 11Z\"/></svg>mean force</li>";
  return html_figure(plot.title, legend, svg_picture(width, height, plot.title, svg), plot.note);
}

}  // namespace gyro::report
