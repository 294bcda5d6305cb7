// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/heat_map.hpp"

#include "app/report/plot/svg.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gyro::report {
namespace {

constexpr double width = 560, height = 310, left = 62, right = width - 84, top = 26, bottom = height - 50;
constexpr int classes = 10;  ///< of colours, h0 to h9 of page.css

/// Class of the colour of a value; -1: no surface.
int class_of(double value, double end) {
  if (!std::isfinite(value)) return -1;
  return std::clamp(static_cast<int>(classes * value / end), 0, classes - 1);
}

/// One path for each colour: neighbours of a row with the same colour are one rectangle.
std::string svg_cells(const Frame& f, const HeatMap& map, double end) {
  std::array<std::string, classes> paths;
  const std::size_t columns = map.x.size() - 1;
  for (std::size_t row = 0; row + 1 < map.y.size(); ++row) {
    const double low = f.y.at(map.y[row]), high = f.y.at(map.y[row + 1]);
    for (std::size_t first = 0, next; first < columns; first = next) {
      const int colour = class_of(map.values[row * columns + first], end);
      for (next = first + 1; next < columns && class_of(map.values[row * columns + next], end) == colour;) ++next;
      if (colour < 0) continue;
      paths[static_cast<std::size_t>(colour)] += "M" + place(f.x.at(map.x[first])) + " " + place(low) + "H" +
                                                 place(f.x.at(map.x[next])) + "V" + place(high) + "H" +
                                                 place(f.x.at(map.x[first])) + "z";
    }
  }
  std::string svg;
  for (std::size_t k = 0; k < paths.size(); ++k)
    if (!paths[k].empty()) svg += "<path class=\"h" + std::to_string(k) + "\" d=\"" + paths[k] + "\"/>";
  return svg;
}

std::string svg_colour_bar(const Frame& f, const HeatMap& map, double end) {
  const double x = f.right + 16, step = (f.bottom - f.top) / classes;
  const Scale scale{0, end, f.bottom, f.top};
  std::string svg;
  for (int k = 0; k < classes; ++k)
    svg += "<rect class=\"h" + std::to_string(k) + "\"" + attribute("x", x) +
           attribute("y", f.bottom - (k + 1) * step) + attribute("width", 14) + attribute("height", step) + "/>";
  for (const Tick& t : linear_ticks(0, end, 5)) svg += svg_text(x + 19, scale.at(t.value), t.label, "start", "middle");
  return svg + svg_text(f.width - 2, 14, map.value_label, "end", "label");
}

}  // namespace

double end_of_scale(std::vector<double> values) {
  constexpr double shown = 0.98;
  std::erase_if(values, [](double v) { return !(v > 0) || !std::isfinite(v); });
  if (values.empty()) return 1;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(shown * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

HeatMap coarsened(const HeatMap& map, std::size_t columns, std::size_t rows) {
  const std::size_t old_columns = map.x.size() - 1, old_rows = map.y.size() - 1;
  const std::size_t across = (old_columns + columns - 1) / columns, down = (old_rows + rows - 1) / rows;
  if (across <= 1 && down <= 1) return map;
  HeatMap coarse = map;
  coarse.x.clear(), coarse.y.clear(), coarse.values.clear();
  for (std::size_t c = 0; c < old_columns; c += across) coarse.x.push_back(map.x[c]);
  for (std::size_t r = 0; r < old_rows; r += down) coarse.y.push_back(map.y[r]);
  coarse.x.push_back(map.x.back()), coarse.y.push_back(map.y.back());
  for (std::size_t r = 0; r < old_rows; r += down)
    for (std::size_t c = 0; c < old_columns; c += across) {
      double sum = 0, cells = 0;
      for (std::size_t i = r; i < std::min(r + down, old_rows); ++i)
        for (std::size_t j = c; j < std::min(c + across, old_columns); ++j)
          if (const double v = map.values[i * old_columns + j]; std::isfinite(v)) sum += v, ++cells;
      coarse.values.push_back(cells > 0 ? sum / cells : std::nan(""));
    }
  return coarse;
}

std::string figure(const HeatMap& given) {
  const HeatMap map = coarsened(given);
  const double end = end_of_scale(map.values);
  const Frame f{width,
                height,
                left,
                top,
                right,
                bottom,
                Scale{map.x.front(), map.x.back(), left, right},
                Scale{map.y.front(), map.y.back(), bottom, top}};
  std::vector<Tick> ticks;
  const bool turn = map.x.back() - map.x.front() > 350 && map.x.back() - map.x.front() < 370;  // degrees
  if (turn)
    for (int degrees = 0; degrees <= 360; degrees += 90)
      ticks.push_back({map.x.front() + degrees, tick_label(std::round(map.x.front() + degrees), 90)});
  else
    ticks = linear_ticks(map.x.front(), map.x.back());
  const std::string svg = "<rect class=\"nosurface\"" + attribute("x", left) + attribute("y", top) +
                          attribute("width", right - left) + attribute("height", bottom - top) + "/>" +
                          svg_cells(f, map, end) +
                          svg_axes(f, ticks, linear_ticks(map.y.front(), map.y.back(), 5), map.x_label, map.y_label) +
                          svg_colour_bar(f, map, end);
  return html_figure(map.title, "", svg_picture(width, height, map.title, svg), map.note);
}

}  // namespace gyro::report
