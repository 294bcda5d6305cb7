// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/plot/line_plot.hpp"

#include "app/report/plot/decimate.hpp"
#include "app/report/plot/svg.hpp"
#include "app/report/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyro::report {
namespace {

constexpr double width = 560, height = 310;
constexpr double left = 62, right = width - 14, top = 26, top_with_marks = 46, bottom = height - 50;

/// Class of a line: colour and dashes by its style, and what it stands for.
std::string line_class(const Curve& curve) {
  std::string name = "line c" + std::to_string(curve.style);
  if (curve.line == Curve::Line::faint) name += " faint";
  if (curve.line == Curve::Line::dashed) name += " estimate";
  return name;
}

struct Limits {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value, bool log) {
    if (!std::isfinite(value) || (log && value <= 0)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range with_ends(Range range, const Axis& axis) {
  return {axis.low.value_or(range.low), axis.high.value_or(range.high)};
}

Range range_of(const Limits& limits, const Axis& axis, double margin) {
  Range range{limits.low, limits.high};
  if (axis.zero) range = {std::min(0.0, range.low), std::max(0.0, range.high)};
  if (axis.log) {
    constexpr double wider = 1.15;
    if (!(range.low > 0) || !std::isfinite(range.high)) return with_ends({1, 10}, axis);
    return with_ends({range.low / wider, range.high * wider}, axis);
  }
  if (range.low == range.high && range.high == 0) range = {0, 1};
  return with_ends(widened(range, margin), axis);
}

Frame frame_of(const LinePlot& plot) {
  Limits x, y;
  for (const Curve& c : plot.curves)
    for (std::size_t k = 0; k < c.x.size(); ++k) {
      x.add(c.x[k], plot.x.log);
      y.add(c.y[k], plot.y.log);
    }
  for (const Area& a : plot.areas)
    for (std::size_t k = 0; k < a.x.size(); ++k) {
      x.add(a.x[k], plot.x.log);
      for (const double value : {a.low[k], a.high[k]}) y.add(value, plot.y.log);
    }
  for (const Mark& m : plot.marks) x.add(m.x, plot.x.log);
  const bool points = std::ranges::any_of(plot.curves, [](const Curve& c) { return c.line == Curve::Line::none; });
  const Range xs = range_of(x, plot.x, points ? 0.05 : 0), ys = range_of(y, plot.y, 0.05);
  const double upper = plot.marks.empty() ? top : top_with_marks;
  return {width,
          height,
          left,
          upper,
          right,
          bottom,
          Scale{xs.low, xs.high, left, right, plot.x.log},
          Scale{ys.low, ys.high, bottom, upper, plot.y.log}};
}

/// The points of a line as the `d` of a path; values that are not finite break it.
std::string path_of(const Frame& f, const std::vector<double>& x, const std::vector<double>& y) {
  std::string path;
  bool pen_down = false;
  for (const std::size_t k : decimated(std::span(y).first(std::min(x.size(), y.size())))) {
    const bool drawn = std::isfinite(x[k]) && std::isfinite(y[k]) && (!f.y.log || y[k] > 0) && (!f.x.log || x[k] > 0);
    if (drawn) path += (pen_down ? "L" : "M") + place(f.x.at(x[k])) + " " + place(f.y.at(y[k]));
    pen_down = drawn;
  }
  return path;
}

/// The closed outline between two curves.
std::string outline_of(const Frame& f, const std::vector<double>& x, const std::vector<double>& low,
                       const std::vector<double>& high) {
  std::string path;
  const std::vector<std::size_t> points = decimated(high);
  for (const std::size_t k : points)
    path += (path.empty() ? "M" : "L") + place(f.x.at(x[k])) + " " + place(f.y.at(high[k]));
  for (auto k = points.rbegin(); k != points.rend(); ++k)
    path += "L" + place(f.x.at(x[*k])) + " " + place(f.y.at(low[*k]));
  return path.empty() ? path : path + "Z";
}

std::string svg_path(const std::string& path, const std::string& css_class) {
  return path.empty() ? "" : "<path class=\"" + css_class + "\" d=\"" + path + "\"/>";
}

std::string svg_points(const Frame& f, const Curve& c) {
  std::string svg;
  if (!c.points) return svg;
  const double radius = c.line == Curve::Line::faint ? 1.5 : 4;
  const std::string css = "dot c" + std::to_string(c.style) + (c.line == Curve::Line::faint ? " faint" : "");
  for (std::size_t k = 0; k < c.x.size(); ++k)
    if (std::isfinite(c.x[k]) && std::isfinite(c.y[k]))
      svg += "<circle class=\"" + css + "\"" + attribute("cx", f.x.at(c.x[k])) + attribute("cy", f.y.at(c.y[k])) +
             attribute("r", radius) + "/>";
  return svg;
}

std::string svg_spans(const Frame& f, const std::vector<Span>& spans) {
  std::string svg;
  for (const Span& s : spans) {
    const double from = std::clamp(f.x.at(s.from), f.left, f.right), to = std::clamp(f.x.at(s.to), f.left, f.right);
    if (to > from)
      svg += "<rect class=\"span " + s.kind + "\"" + attribute("x", from) + attribute("y", f.top) +
             attribute("width", to - from) + attribute("height", f.bottom - f.top) + "/>";
  }
  return svg;
}

/// Lines of the marks; the names of neighbours face away from each other.
std::string svg_marks(const Frame& f, std::vector<Mark> marks) {
  std::ranges::sort(marks, {}, &Mark::x);
  std::string svg;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    const double at = f.x.at(marks[k].x);
    const bool first = k == 0 && marks.size() > 1 && at > (f.left + f.right) / 4;
    svg += svg_line(at, f.top, at, f.bottom, "mark") +
           svg_text(at + (first ? -3 : 3), f.top - 5, marks[k].name, first ? "end" : "start", "markname");
  }
  return svg;
}

std::string svg_spots(const Frame& f, const std::vector<Spot>& spots) {
  std::string svg;
  for (const Spot& s : spots) {
    const double x = f.x.at(s.x), y = f.y.at(s.y);
    const std::string style = " c" + std::to_string(s.style);
    svg += svg_line(x, y, x, f.bottom, "drop" + style) + "<circle class=\"dot" + style + "\"" + attribute("cx", x) +
           attribute("cy", y) + attribute("r", 4.5) + "/>";
  }
  return svg;
}

/// What is cut off at the frame, with room for the width of lines: an inner <svg> does that without an id.
std::string svg_inside(const Frame& f, const std::string& content) {
  constexpr double room = 5;
  const double w = f.right - f.left + 2 * room, h = f.bottom - f.top + 2 * room;
  return "<svg" + attribute("x", f.left - room) + attribute("y", f.top - room) + attribute("width", w) +
         attribute("height", h) + " viewBox=\"" + place(f.left - room) + " " + place(f.top - room) + " " + place(w) +
         " " + place(h) + "\">" + content + "</svg>";
}

std::string legend_entry(const std::string& sample, const std::string& name) {
  return "<li><svg viewBox=\"0 0 30 12\" class=\"sample\" aria-hidden=\"true\">" + sample + "</svg>" + escape(name) +
         "</li>";
}

std::string legend_of(const LinePlot& plot) {
  std::string legend;
  for (const Area& a : plot.areas)
    legend +=
        legend_entry("<rect class=\"area c" + std::to_string(a.style) + "\" width=\"30\" height=\"12\"/>", a.name);
  for (const Curve& c : plot.curves) {
    if (c.name.empty()) continue;
    std::string sample = c.line == Curve::Line::none ? "" : svg_line(0, 6, 30, 6, line_class(c));
    if (c.points)
      sample += "<circle class=\"dot c" + std::to_string(c.style) + "\" cx=\"15\" cy=\"6\" r=\"" +
                (c.line == Curve::Line::faint ? "2" : "4") + "\"/>";
    legend += legend_entry(sample, c.name);
  }
  for (const Span& s : plot.spans)
    if (!s.name.empty())
      legend += legend_entry("<rect class=\"span " + s.kind + "\" width=\"30\" height=\"12\"/>", s.name);
  return legend;
}

std::vector<Tick> ticks_of(const Axis& axis, const Scale& scale, int wanted) {
  if (scale.log) return log_ticks(scale.low, scale.high);
  if (!(axis.step > 0)) return linear_ticks(scale.low, scale.high, wanted);
  std::vector<Tick> ticks;
  for (double value = std::ceil(scale.low / axis.step) * axis.step; value <= scale.high; value += axis.step)
    ticks.push_back({value, tick_label(value, axis.step)});
  return ticks;
}

}  // namespace

bool has_points(const LinePlot& plot) {
  const auto finite = [](const std::vector<double>& values) {
    return std::ranges::any_of(values, [](double v) { return std::isfinite(v); });
  };
  return std::ranges::any_of(plot.curves, [&](const Curve& c) { return finite(c.x) && finite(c.y); }) ||
         std::ranges::any_of(plot.areas, [&](const Area& a) { return finite(a.high); });
}

std::string figure(const LinePlot& plot) {
  const Frame f = frame_of(plot);
  std::string inside;
  for (const Area& a : plot.areas)
    inside += svg_path(outline_of(f, a.x, a.low, a.high), "area c" + std::to_string(a.style));
  for (const Curve& c : plot.curves) {
    if (c.line != Curve::Line::none && !(c.points && c.line == Curve::Line::faint))
      inside += svg_path(path_of(f, c.x, c.y), line_class(c));
    inside += svg_points(f, c);
  }
  const std::string svg = svg_spans(f, plot.spans) +
                          svg_axes(f, ticks_of(plot.x, f.x, 6), ticks_of(plot.y, f.y, 5), plot.x.label, plot.y.label) +
                          svg_inside(f, inside) + svg_marks(f, plot.marks) + svg_spots(f, plot.spots);
  return html_figure(plot.title, legend_of(plot), svg_picture(width, height, plot.title, svg), plot.note);
}

}  // namespace gyro::report
